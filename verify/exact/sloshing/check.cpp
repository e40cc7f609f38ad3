// Small waves in a tank that is swayed to and fro.
#include "verify/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// Linear waves of an ideal liquid of depth d in a tank of length L whose place is
/// X(t) = A (1 - cos(w t)), from rest. Seen from the tank the surface is the sum of its modes,
///   eta = sum_n b_n(t) cos(k_n x),  k_n = n pi / L,  n odd,
///   b_n'' + w_n^2 b_n = 4 kappa_n / (L k_n^2) X'',  kappa_n = k_n tanh(k_n d),  w_n^2 = g kappa_n
/// after Faltinsen & Timokha, Sloshing (2009), section 5.3, for surge. With X'' = A w^2 cos(w t):
///   b_n = 4 kappa_n A w^2 / (L k_n^2) (cos(w t) - cos(w_n t)) / (w_n^2 - w^2)
class SwayedTank {
 public:
  double length, depth, g, amplitude, frequency;  // m, m, m/s^2, m, rad/s

  /// The velocity of the centre of mass against the tank [m/s]: of its place
  ///   sum_n b_n c_n / (2 d), with c_n = -4 / (L k_n^2) the modes of x - L/2.
  double velocity_of_center(double t) const {
    double sum = 0.0;
    for (int n = 1; n < 40; n += 2) {
      double const k = n * std::numbers::pi / length;
      double const kappa = k * std::tanh(k * depth);
      double const w_n = std::sqrt(g * kappa);
      double const drive = 4.0 * kappa * amplitude * frequency * frequency / (length * k * k);
      double const rate = drive * (w_n * std::sin(w_n * t) - frequency * std::sin(frequency * t)) /
                          (w_n * w_n - frequency * frequency);
      sum -= rate * 4.0 / (length * k * k) / (2.0 * depth);
    }
    return sum;
  }
};

}  // namespace

std::vector<CheckResult> check_sloshing(Effort effort) {
  Case tank = shipped_case("sloshing-tank");
  SwayedTank const exact{1.0, 0.4, -tank.gravity[1], 0.02, 3.0};
  if (effort == Effort::quick) tank.time.end = 1.0;
  Simulation simulation(build_model(tank));
  double const mass = simulation.sums().mass;
  double const energy_before = simulation.sums().total_energy();
  double worst = 0.0, worst_time = 0.0, largest = 0.0, largest_energy = 0.0;
  while (simulation.running()) {
    simulation.advance();
    double const t = simulation.time();
    double const tank_velocity = exact.amplitude * exact.frequency * std::sin(exact.frequency * t);
    ConservedSums const sums = simulation.sums();
    double const measured = sums.momentum[0] / mass - tank_velocity;
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
