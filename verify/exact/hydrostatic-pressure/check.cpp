// Water at rest in an open tank.
#include "verify/check.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {

std::vector<CheckResult> check_hydrostatic_pressure(Effort effort) {
  constexpr double density = 1000.0;    // kg/m^3
  constexpr double depth = 0.5;         // m
  constexpr double sound_speed = 31.3;  // m/s
  Case tank = shipped_case("hydrostatic-tank");
  double const g = -tank.gravity[1];
  if (effort == Effort::quick) tank.numerics.spacing *= 2.0;
  Simulation simulation(build_model(tank));
  double fastest = 0.0;
  ParticleStore const& store = simulation.particles();
  std::size_t const count = store.range(Kind::fluid).size();
  while (simulation.running()) {
    simulation.advance();
    for (std::size_t i = 0; i < count; ++i)
      fastest = std::max(fastest, std::hypot(store.component(Field::velocity, 0)[i],
                                             store.component(Field::velocity, 1)[i]));
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double const expected = density * g * (depth - store.component(Field::position, 1)[i]);
    worst = std::max(worst, std::fabs(store.scalar(Field::pressure)[i] - expected));
  }
  return {at_most("hydrostatic-pressure: profile", worst / (density * g * depth), 0.01, "-",
                  "largest error of any particle / rho g H, after 62 H / c"),
          at_most("hydrostatic-pressure: motion", fastest / sound_speed, 1e-3, "-",
                  "largest speed of any particle at any time / c")};
}

}  // namespace moraine
