#include "exact/hugoniot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

constexpr double step = 1.05;             // between compressions that are tried
constexpr double most_compression = 1e6;  // of rho/rho_0 - 1

// The state ahead of a shock.
struct Ahead {
  double density;
  double pressure;
  double specific_energy;
  double sound_speed;
};

Ahead ahead_of(Law const& law, double density, double specific_energy) {
  if (!(density > 0.0)) throw std::invalid_argument("shock: density must be positive");
  Ahead const ahead{density, law.pressure(density, specific_energy), specific_energy,
                    law.sound_speed(density, specific_energy)};
  if (!(ahead.sound_speed > 0.0))
    throw std::invalid_argument("shock: the state ahead has no sound speed");
  return ahead;
}

// The least compression s = rho/rho_0 - 1 above `low` at which `excess` is not negative.
template <class F>
double compression(F const& excess, double low) {
  while (!(excess(low) < 0.0)) {
    low *= 0.5;
    if (low < 1e-300) return low;
  }
  for (double high = low * step; high < most_compression; low = high, high *= step)
    if (!(excess(high) < 0.0)) {
      double const root = bisect(excess, low, high);
      // A law that has a pole jumps from negative to no number at all, or to minus infinity.
      if (std::isfinite(excess(root))) return root;
      break;
    }
  throw std::domain_error("shock: the equation of state has no such shock");
}

}  // namespace

ShockState shock_from_piston(Law const& law, double density, double specific_energy,
                             double piston_velocity) {
  double const u = piston_velocity;
  if (!(u >= 0.0 && std::isfinite(u)))
    throw std::invalid_argument("shock: the piston's velocity must be finite and not negative");
  Ahead const ahead = ahead_of(law, density, specific_energy);
  if (u == 0.0) return {ahead.sound_speed, density, ahead.pressure, specific_energy};
  // The compression gives the shock speed u (1 + 1/s).
  auto const behind = [&](double s) -> ShockState {
    double const speed = u * (1.0 + 1.0 / s);
    return {speed, density * (1.0 + s), ahead.pressure + density * speed * u,
            specific_energy + ahead.pressure * u / (density * speed) + 0.5 * u * u};
  };
  auto const excess = [&](double s) {
    ShockState const state = behind(s);
    return law.pressure(state.density, state.specific_energy) - state.pressure;
  };
  // A weak shock compresses by u/c; small compressions mean fast shocks, above the root sought.
  return behind(compression(excess, 1e-3 * u / (ahead.sound_speed + u)));
}

ShockWave shock_to_pressure(Law const& law, double density, double specific_energy,
                            double pressure) {
  Ahead const ahead = ahead_of(law, density, specific_energy);
  double const jump = pressure - ahead.pressure;
  if (!(jump >= 0.0 && std::isfinite(jump)))
    throw std::invalid_argument("shock: the pressure behind is below the one ahead");
  if (jump == 0.0) return {{ahead.sound_speed, density, ahead.pressure, specific_energy}, 0.0};
  double const mean = 0.5 * (pressure + ahead.pressure);
  auto const energy = [&](double s) { return specific_energy + mean * s / (density * (1.0 + s)); };
  auto const excess = [&](double s) {
    return law.pressure(density * (1.0 + s), energy(s)) - pressure;
  };
  double const stiffness = density * ahead.sound_speed * ahead.sound_speed;
  double const s = compression(excess, 1e-3 * jump / (stiffness + jump));
  double const speed = std::sqrt(jump * (1.0 + s) / (density * s));
  return {{speed, density * (1.0 + s), pressure, energy(s)}, jump / (density * speed)};
}

std::vector<ShockWave> hugoniot_curve(Law const& law, double density, double specific_energy,
                                      double fastest_piston, int count) {
  std::vector<ShockWave> curve;
  for (int k = 0; k < count; ++k) {
    double const u = fastest_piston * k / std::max(count - 1, 1);
    try {
      curve.push_back({shock_from_piston(law, density, specific_energy, u), u});
    } catch (std::domain_error const&) {
      break;
    }
  }
  return curve;
}

}  // namespace moraine
