#include "exact/hugoniot.hpp"

#include <cmath>
#include <stdexcept>
#include <variant>

#include "base/bisect.hpp"

namespace moraine {
namespace {

// The jump conditions for one state ahead and one piston velocity.
struct Jump {
  double density;
  double pressure;
  double specific_energy;
  double piston_velocity;

  ShockState behind(double shock_speed) const {
    double const u = piston_velocity;
    return {shock_speed, density * shock_speed / (shock_speed - u),
            pressure + density * shock_speed * u,
            specific_energy + pressure * u / (density * shock_speed) + 0.5 * u * u};
  }
};

// The unknown is the compression s = rho/rho_0 - 1, which gives the shock speed u (1 + 1/s).
template <class Law>
ShockState solve(Law const& law, Jump const& jump) {
  auto const behind = [&jump](double compression) {
    return jump.behind(jump.piston_velocity * (1.0 + 1.0 / compression));
  };
  auto const excess = [&](double compression) {
    ShockState const state = behind(compression);
    return law.pressure(state.density, state.specific_energy) - state.pressure;
  };
  double const c = law.sound_speed(jump.density, jump.specific_energy);
  // A weak shock compresses by u/c; small compressions mean fast shocks, above the root sought.
  double low = 1e-3 * jump.piston_velocity / (c + jump.piston_velocity);
  while (!(excess(low) < 0.0)) low *= 0.5;
  constexpr double step = 1.05;
  for (double high = low * step; high < 1e6; low = high, high *= step)
    if (excess(high) >= 0.0) return behind(bisect(excess, low, high));
  throw std::domain_error("shock from piston: the equation of state has no such shock");
}

}  // namespace

ShockState shock_from_piston(Eos const& eos, double density, double specific_energy,
                             double piston_velocity) {
  if (!(density > 0.0)) throw std::invalid_argument("shock from piston: density must be positive");
  if (!(piston_velocity >= 0.0 && std::isfinite(piston_velocity)))
    throw std::invalid_argument("shock from piston: the velocity must be finite and not negative");
  return std::visit(
      [&](auto const& law) -> ShockState {
        StateResponse const ahead = law.respond(density, specific_energy);
        if (!(ahead.sound_speed > 0.0))
          throw std::invalid_argument("shock from piston: the state ahead has no sound speed");
        if (piston_velocity == 0.0)
          return {ahead.sound_speed, density, ahead.pressure, specific_energy};
        return solve(law, {density, ahead.pressure, specific_energy, piston_velocity});
      },
      eos);
}

}  // namespace moraine
