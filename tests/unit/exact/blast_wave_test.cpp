// Noh's implosion and Sedov's blast wave.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "exact/noh.hpp"
#include "exact/sedov.hpp"
#include "unit/exact/integral.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

constexpr FlowGeometry geometries[] = {FlowGeometry::planar, FlowGeometry::cylindrical,
                                       FlowGeometry::spherical};

double energy_density(FlowState const& s) {
  return s.density * (s.specific_energy + 0.5 * s.velocity * s.velocity);
}

// Noh (1987): 4, 16, 64 and a shock at 0.2 at t = 0.6 for gamma = 5/3.
TEST(Noh, StagnationStates) {
  for (FlowGeometry const geometry : geometries) {
    Noh const noh{geometry, 5.0 / 3.0, 1.0, 1.0};
    double const rho = std::pow(4.0, dimensions(geometry));
    EXPECT_NEAR(noh.stagnation_density(), rho, 1e-12 * rho);
    EXPECT_NEAR(noh.shock_position(0.6), 0.2, 1e-15);
    EXPECT_NEAR(noh.sample(0.1, 0.6).pressure, rho / 3.0, 1e-12 * rho);
    EXPECT_EQ(noh.sample(0.3, 0.6).velocity, -1.0);
    EXPECT_EQ(noh.sample(0.0, 0.0).density, 1.0);
  }
}

// The gas that began inside of r = 1 is inside of 1 - u_0 t, all of it, with all its energy.
TEST(Noh, ConservesMassAndEnergy) {
  double const t = 0.6;
  for (FlowGeometry const geometry : geometries) {
    Noh const noh{geometry, 1.4, 2.0, 0.5};
    int const j = dimensions(geometry);
    double const shock = noh.shock_position(t), outside = 1.0 - 0.5 * t;
    auto const all = [&](auto const& density) {
      return integral([&](double r) { return density(noh.sample(r, t)) * std::pow(r, j - 1); },
                      {0.0, shock, outside});
    };
    EXPECT_NEAR(all([](FlowState const& s) { return s.density; }), 2.0 / j, 1e-10);
    EXPECT_NEAR(all(energy_density), 2.0 / j * 0.125, 1e-10);
  }
}

// Mass, momentum and energy across the shock.
TEST(Noh, ShockObeysTheJumpConditions) {
  for (FlowGeometry const geometry : geometries) {
    Noh const noh{geometry, 5.0 / 3.0, 1.0, 1.0};
    double const speed = noh.shock_position(1.0);
    FlowState const a = noh.sample(speed * (1.0 - 1e-14), 1.0), b = noh.sample(speed, 1.0);
    EXPECT_NEAR(a.density * speed, b.density * (speed + 1.0), 1e-10 * b.density);
    EXPECT_NEAR(a.pressure, b.density * (speed + 1.0), 1e-10 * b.density);
    EXPECT_NEAR(a.specific_energy, 0.5, 1e-15);
  }
}

// alpha by 30-digit quadrature in the similarity variable V, of the formulas of Kamm and Timmes
// (2007); their planar energy 0.0673185, 0.311357 and 0.851072 put the shock at 0.5, 0.75 and 1.
TEST(Sedov, EnergyCoefficients) {
  double const expected[] = {0.538742792367526584, 0.984074016880044845, 0.851071854758228980};
  double const energy[] = {0.0673185, 0.311357, 0.851072};
  double const position[] = {0.5, 0.75, 1.0};
  for (std::size_t k = 0; k < 3; ++k) {
    Sedov const sedov({geometries[k], 1.4, 1.0, energy[k]});
    EXPECT_NEAR(sedov.alpha(), expected[k], 1e-12);
    EXPECT_NEAR(sedov.shock_position(1.0), position[k], 2e-4);
  }
}

// All gas that the shock has met is behind it, with the energy of the source.
TEST(Sedov, ConservesMassAndEnergy) {
  for (FlowGeometry const geometry : geometries)
    for (double const gamma : {1.2, 1.4, 5.0 / 3.0, 2.001, 3.0}) {
      SedovBlast const blast{geometry, gamma, 1.3, 7.0};
      Sedov const sedov(blast);
      int const j = dimensions(geometry);
      double const t = 0.3, shock = sedov.shock_position(t);
      auto const all = [&](auto const& density) {
        return unit_area(geometry) *
               integral([&](double r) { return density(sedov.sample(r, t)) * std::pow(r, j - 1); },
                        {1e-9 * shock, 0.1 * shock, 0.5 * shock, 0.9 * shock, shock});
      };
      double const mass = unit_area(geometry) * 1.3 * std::pow(shock, j) / j;
      EXPECT_NEAR(all([](FlowState const& s) { return s.density; }), mass, 1e-8 * mass)
          << j << " gamma " << gamma;
      EXPECT_NEAR(all(energy_density), 7.0, 7e-8) << j << " gamma " << gamma;
    }
}

TEST(Sedov, ShockObeysTheJumpConditions) {
  for (FlowGeometry const geometry : geometries) {
    Sedov const sedov({geometry, 1.4, 1.0, 1.0});
    double const speed = sedov.shock_speed(2.0);
    FlowState const at = sedov.sample(sedov.shock_position(2.0), 2.0);
    EXPECT_NEAR(at.density * (speed - at.velocity), speed, 1e-10 * speed);
    EXPECT_NEAR(at.pressure, speed * at.velocity, 1e-10 * at.pressure);
    EXPECT_NEAR(at.specific_energy, 0.5 * at.velocity * at.velocity, 1e-10 * at.specific_energy);
    // The speed is the rate of the position.
    double const rate = (sedov.shock_position(2.001) - sedov.shock_position(1.999)) / 0.002;
    EXPECT_NEAR(speed, rate, 1e-6 * rate);
    EXPECT_EQ(sedov.sample(0.0, 1.0).density, 0.0);
    EXPECT_EQ(sedov.sample(100.0, 1.0).density, 1.0);
  }
}

// The flow solves Euler's equations: continuity and entropy by central differences.
TEST(Sedov, SolvesEulersEquations) {
  for (FlowGeometry const geometry : geometries) {
    Sedov const sedov({geometry, 1.4, 1.0, 1.0});
    int const j = dimensions(geometry);
    double const t = 1.0, shock = sedov.shock_position(t), step = 1e-5;
    for (double const part : {0.5, 0.7, 0.95}) {
      double const r = part * shock;
      auto const along_r = [&](auto const& f) {
        return (f(sedov.sample(r + step, t), r + step) - f(sedov.sample(r - step, t), r - step)) /
               (2.0 * step);
      };
      auto const along_t = [&](auto const& f) {
        return (f(sedov.sample(r, t + step)) - f(sedov.sample(r, t - step))) / (2.0 * step);
      };
      FlowState const at = sedov.sample(r, t);
      double const rho_t = along_t([](FlowState const& s) { return s.density; });
      double const flow = along_r([j](FlowState const& s, double x) {
        return s.density * s.velocity * std::pow(x, j - 1);
      });
      EXPECT_NEAR(rho_t + flow / std::pow(r, j - 1), 0.0, 1e-6 * at.density) << part;
      double const u_t = along_t([](FlowState const& s) { return s.velocity; });
      double const u_r = along_r([](FlowState const& s, double) { return s.velocity; });
      double const p_r = along_r([](FlowState const& s, double) { return s.pressure; });
      EXPECT_NEAR(u_t + at.velocity * u_r + p_r / at.density, 0.0, 1e-6 * std::fabs(u_t)) << part;
    }
  }
}

TEST(Sedov, RefusesWhatIsNotTheStandardCase) {
  auto const refusal = [](double gamma, double energy) {
    return message_of<std::invalid_argument>([&] {
      Sedov({FlowGeometry::spherical, gamma, 1.0, energy});
    });
  };
  EXPECT_EQ(refusal(7.0, 1.0),
            "Sedov: the heat capacity ratio must be above 1, and below 7 for spheres");
  EXPECT_EQ(refusal(1.0, 1.0), refusal(7.0, 1.0));
  EXPECT_NE(refusal(2.0, 1.0).find("diverge"), std::string::npos);
  EXPECT_EQ(refusal(1.4, 0.0), "Sedov: density and energy must be positive");
}

}  // namespace
}  // namespace moraine
