// What stops a run, and whom the message names.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "step/simulation_error.hpp"
#include "step/time_step.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Model box() {
  RandomBox settings;
  settings.side = 12;
  return random_box(settings, 1.0);
}

/// The message of the SimulationError of a start and some steps; empty if there is none.
std::string error_of(Model model, int steps) {
  try {
    Simulation simulation(std::move(model));
    for (int step = 0; step < steps; ++step) simulation.advance();
  } catch (SimulationError const& error) {
    return error.what();
  }
  return "";
}

bool has(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

TEST(Guard, NamesTheParticleWithoutAPlace) {
  for (double const x : {nan, infinity, -infinity})
    for (bool const periodic : {false, true}) {
      Model model = box();
      if (!periodic) model.periodic = {};
      model.particles.component(Field::position, 1)[17] = x;
      std::string const message = error_of(std::move(model), 0);
      EXPECT_TRUE(has(message, "particle 17 (light)")) << message;
      EXPECT_TRUE(has(message, "its position is not a finite number")) << message;
    }
}

TEST(Guard, NamesTheParticleThatIsNoNumber) {
  for (Field const field : {Field::velocity, Field::density, Field::specific_energy}) {
    Model model = box();
    model.particles.component(field, 0)[23] = nan;
    EXPECT_TRUE(has(error_of(std::move(model), 1), "unstable: particle")) << info(field).name;
  }
}

// Particles at rest but one, alone: that one is meant.
Model loner(double speed) {
  RandomBox settings;
  settings.side = 2;
  Model model = random_box(settings, 1.0);
  model.periodic = {};
  model.domain_min = {-100.0, -100.0, 0.0};
  model.domain_max = {100.0, 100.0, 0.0};
  for (int axis = 0; axis < 2; ++axis)
    for (std::size_t i = 0; i < 4; ++i) {
      model.particles.component(Field::position, axis)[i] = static_cast<double>(i);
      model.particles.component(Field::velocity, axis)[i] = 0.0;
    }
  model.particles.component(Field::velocity, 0)[3] = speed;
  return model;
}

TEST(Guard, StopsAFixedStepThatCarriesAParticleBeyondItsSmoothingLength) {
  double const h = loner(0.0).numerics.smoothing_length();
  for (double const part : {0.99, 1.01}) {
    Model model = loner(50.0);
    model.time.fixed_step = part * h / 50.0;
    std::string const message = error_of(std::move(model), 3);
    EXPECT_EQ(!message.empty(), part > 1.0) << message;
    if (part < 1.0) continue;
    EXPECT_TRUE(has(message, "unstable: particle 3 (heavy)")) << message;
    EXPECT_TRUE(has(message, "farther than the smoothing length")) << message;
    EXPECT_TRUE(has(message, "limited by fixed step")) << message;
  }
}

// A step that is voted is short enough for any speed, so that the guard never meets it: half a
// smoothing length by the vote, and what the acceleration of one step adds.
TEST(Guard, NeverMeetsAVotedStep) {
  for (double const speed : {1e2, 1e4, 1e8}) {
    Simulation simulation(loner(speed));
    for (int step = 0; step < 20; ++step) simulation.advance();
    EXPECT_EQ(simulation.vote().reason, speed > 1e3 ? "motion" : "sound and viscosity");
    if (speed > 1e3) {
      EXPECT_EQ(simulation.vote().particle, 3U);
      EXPECT_NEAR(simulation.time_step() * speed,
                  0.5 * simulation.model().numerics.smoothing_length(), 1e-12);
    }
  }
}

TEST(Guard, NamesWhoStopsTheClock) {
  Model mute = loner(100.0);
  mute.time.courant = nan;
  std::string const message = error_of(std::move(mute), 1);
  // The stiffest particle asks for the step of sound: the first of the two heavy ones.
  EXPECT_TRUE(has(message,
                  "unstable: particle 1 (heavy) at (1, 1) m: a time step of nan s (sound "
                  "and viscosity) does not move the clock"))
      << message;
  EXPECT_TRUE(has(message, "limited by sound and viscosity of particle 1")) << message;
  Model model = loner(100.0);
  model.time.max_step = -1.0;
  EXPECT_EQ(error_of(std::move(model), 1),
            "a time step of -1 s (largest step) does not move the clock; time 0 s, step 0");
}

TEST(Votes, WhatIsNoNumberWins) {
  Vote const good{1.0, "good", 1};
  Vote const bad{nan, "bad", 2};
  EXPECT_EQ(stricter(good, bad).reason, "bad");
  EXPECT_EQ(stricter(bad, good).reason, "bad");
  EXPECT_EQ(stricter(good, Vote{2.0, "long", 3}).reason, "good");
  EXPECT_EQ(stricter(good, Vote{0.5, "short", 3}).reason, "short");
}

TEST(SweepOutcome, KeepsTheFirstThatIsNoNumber) {
  SweepOutcome outcome;
  outcome.include(3.0, 1);
  outcome.include(2.0, 2);
  EXPECT_EQ(outcome.particle, 1U);
  outcome.include(nan, 3);
  outcome.include(5.0, 4);
  outcome.include(nan, 5);
  EXPECT_EQ(outcome.particle, 3U);
}

}  // namespace
}  // namespace moraine
