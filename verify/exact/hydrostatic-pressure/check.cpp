// Water at rest in an open tank.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// Still water of a Tait law in a tank, filled so that its undisturbed depth would be `depth`:
///
///   dp/dz = -rho g,  p(0) = rho_0 g depth (the weight of the water)
///
/// With the enthalpy c_0^2 / (gamma - 1) ((rho/rho_0)^(gamma-1) - 1), whose slope is -g:
///   (rho/rho_0)^(gamma-1) = (rho_bottom/rho_0)^(gamma-1) - (gamma - 1) g z / c_0^2
class StillWater {
 public:
  StillWater(Tait const& water, double g, double depth)
      : water_(water),
        scale_((water.exponent - 1.0) * g / std::pow(water.reference_sound_speed, 2)) {
    double const bottom = water.density_at_pressure(water.reference_density * g * depth, 0.0);
    bottom_ = std::pow(bottom / water.reference_density, water.exponent - 1.0);
  }
  double pressure(double z) const {
    double const ratio = std::pow(bottom_ - scale_ * z, 1.0 / (water_.exponent - 1.0));
    return water_.pressure(ratio * water_.reference_density, 0.0);
  }

 private:
  Tait water_;
  double scale_;   // 1/m
  double bottom_;  // (rho/rho_0)^(gamma-1) at z = 0
};

/// The largest error of the pressure of any particle, over the pressure at the bottom.
struct WorstError {
  double error = 0.0;
  double height = 0.0;  // m
  double time = 0.0;    // s
};

}  // namespace

std::vector<CheckResult> check_hydrostatic_pressure(Effort effort) {
  constexpr double depth = 0.5;  // m
  constexpr int samples = 20;
  Case tank = shipped_case("hydrostatic-tank");
  Tait const water = std::get<Tait>(tank.materials.front().eos);
  double const g = -tank.gravity[1];
  StillWater const exact(water, g, depth);
  if (effort == Effort::quick) tank.time.end *= 0.25;
  Simulation simulation(build_model(tank));
  ParticleStore const& store = simulation.particles();
  double fastest = 0.0;
  WorstError worst;
  int sampled = 0;
  while (simulation.running()) {
    simulation.advance();
    std::size_t const count = store.range(Kind::fluid).size();
    for (std::size_t i = 0; i < count; ++i)
      fastest = std::max(fastest, std::hypot(store.component(Field::velocity, 0)[i],
                                             store.component(Field::velocity, 1)[i]));
    if (simulation.running() && simulation.time() * samples < tank.time.end * (sampled + 1))
      continue;
    ++sampled;
    for (std::size_t i = 0; i < count; ++i) {
      double const z = store.component(Field::position, 1)[i];
      double const error = std::fabs(store.scalar(Field::pressure)[i] - exact.pressure(z)) /
                           (water.reference_density * g * depth);
      if (error > worst.error) worst = {error, z, simulation.time()};
    }
  }
  return {
      at_most("hydrostatic-pressure: profile", worst.error, 0.01, "-",
              fmt::format("largest error / rho g H of any particle at {} times until {:g} s: at "
                          "z = {:.3f} m, {:.2f} s",
                          samples, tank.time.end, worst.height, worst.time)),
      at_most("hydrostatic-pressure: motion", fastest / water.reference_sound_speed, 1e-3, "-",
              "largest speed of any particle at any time / c")};
}

}  // namespace moraine
