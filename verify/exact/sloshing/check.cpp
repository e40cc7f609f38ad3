// Small waves in a tank that is swayed to and fro.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "setup/build_model.hpp"
#include "sloshing/rigid_tank.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// A rigid tank whose place is X(t) = A (1 - cos(w t)), from rest. By linear theory
/// (sloshing/rigid_tank.hpp) each mode is an oscillator, D_n'' + w_n^2 D_n = -X'', so
///   D_n = A w^2 (cos(w_n t) - cos(w t)) / (w_n^2 - w^2)
class SwayedTank {
 public:
  SwayedTank(RigidTank const& tank, double amplitude, double frequency)
      : mass_(tank.mass()), amplitude_(amplitude), frequency_(frequency) {
    for (int n = 1; n < 40; n += 2) modes_.push_back(sloshing_mode(tank, n));
  }

  double velocity(double t) const { return amplitude_ * frequency_ * std::sin(frequency_ * t); }

  /// The velocity of the liquid's centre of mass against the tank [m/s], sum m_n / m D_n'.
  double velocity_of_center(double t) const {
    double const w = frequency_;
    double sum = 0.0;
    for (SloshingMode const& mode : modes_) {
      double const w_n = mode.angular_frequency;
      sum += mode.mass / mass_ * amplitude_ * w * w *
             (w * std::sin(w * t) - w_n * std::sin(w_n * t)) / (w_n * w_n - w * w);
    }
    return sum;
  }

 private:
  std::vector<SloshingMode> modes_;
  double mass_;       // kg
  double amplitude_;  // m
  double frequency_;  // rad/s
};

}  // namespace

std::vector<CheckResult> check_sloshing(Effort effort) {
  Case tank = shipped_case("sloshing-tank");
  SwayedTank const exact(
      {.length = 1.0, .depth = 0.4, .density = 1000.0, .gravity = -tank.gravity[1]}, 0.02, 3.0);
  if (effort == Effort::quick) tank.time.end = 1.0;
  Simulation simulation(build_model(tank));
  double const mass = simulation.sums().mass;
  double const energy_before = simulation.sums().total_energy();
  double worst = 0.0, worst_time = 0.0, largest = 0.0, largest_energy = 0.0;
  while (simulation.running()) {
    simulation.advance();
    double const t = simulation.time();
    ConservedSums const sums = simulation.sums();
    double const measured = sums.momentum[0] / mass - exact.velocity(t);
    double const reference = exact.velocity_of_center(t);
    largest = std::max(largest, std::fabs(reference));
    largest_energy = std::max(largest_energy, sums.kinetic_energy);
    if (std::fabs(measured - reference) <= worst) continue;
    worst = std::fabs(measured - reference);
    worst_time = t;
  }
  double const gained = simulation.sums().total_energy() - energy_before;
  return {
      at_most("sloshing: velocity of the centre of mass", worst / largest, 0.08, "-",
              fmt::format("largest difference from linear theory until {:g} s, at {:.2f} s, over "
                          "the largest velocity, {:.4f} m/s",
                          tank.time.end, worst_time, largest)),
      at_most("sloshing: energy", (gained - simulation.booked().walls) / largest_energy, 0.01, "-",
              "energy gained less work of the walls, over the largest kinetic energy"),
      at_most("sloshing: particles", static_cast<double>(simulation.lost().count), 0.0, "-",
              "lost")};
}

}  // namespace moraine
