#include "exact/detonation.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "base/bisect.hpp"

namespace moraine {
namespace {

constexpr double least_ratio = 1.005, most_ratio = 4.0, ratio_step = 1.005;  // of rho / rho_0

// The detonation with density `rho` behind it; no number for the speed where there is none.
Detonation with_density(Explosive const& explosive, double rho) {
  double const released = 1.0 / explosive.density - 1.0 / rho;
  auto const excess = [&](double p) {
    return explosive.products.pressure(rho, explosive.specific_energy + 0.5 * p * released) - p;
  };
  // Linear in p: the secant through any two pressures hits the root.
  double const at_zero = excess(0.0);
  double const slope = (excess(at_zero) - at_zero) / at_zero;
  double const p = -at_zero / slope;
  double const e = explosive.specific_energy + 0.5 * p * released;
  double const speed =
      slope < 0.0 && p > 0.0 ? std::sqrt(p / released) / explosive.density : std::nan("");
  return {speed,
          {rho, speed * (1.0 - explosive.density / rho), p, e},
          explosive.products.sound_speed(rho, e)};
}

}  // namespace

Detonation chapman_jouguet(Explosive const& explosive) {
  if (!(explosive.density > 0.0 &&
        explosive.products.pressure(explosive.density, explosive.specific_energy) > 0.0))
    throw std::invalid_argument("detonation: the products have no pressure at the solid's density");
  std::vector<double> touching;
  double last = with_density(explosive, explosive.density * least_ratio).speed;
  double next = with_density(explosive, explosive.density * least_ratio * ratio_step).speed;
  for (double ratio = least_ratio * ratio_step; ratio < most_ratio && std::isfinite(next);
       ratio *= ratio_step) {
    double const beyond = with_density(explosive, explosive.density * ratio * ratio_step).speed;
    if (next <= last && next < beyond) touching.push_back(ratio);
    last = std::exchange(next, beyond);
  }
  if (touching.size() != 1)
    throw std::domain_error(
        touching.empty() ? "detonation: no Rayleigh line touches the Hugoniot of the products"
                         : "detonation: more than one Rayleigh line touches the Hugoniot");
  // At densities below that of the C-J state the flow behind is supersonic.
  double const rho = bisect(
      [&](double density) {
        Detonation const at = with_density(explosive, density);
        return at.behind.velocity + at.sound_speed - at.speed;
      },
      explosive.density * touching.front() / ratio_step,
      explosive.density * touching.front() * ratio_step);
  return with_density(explosive, rho);
}

TaylorWave::TaylorWave(Explosive explosive)
    : explosive_(std::move(explosive)),
      detonation_(chapman_jouguet(explosive_)),
      isentrope_(explosive_.products, detonation_.behind.density,
                 detonation_.behind.specific_energy) {
  double const u = detonation_.behind.velocity;
  IsentropeState const at =
      isentrope_.where([u](IsentropeState const& s) { return u - s.velocity_change; });
  if (!isentrope_.spreads() || !(isentrope_.end().velocity_change > u))
    throw std::domain_error("detonation: the products cannot come to rest behind the wave");
  rest_ = {at.density, 0.0, at.pressure, at.specific_energy};
  rest_speed_ = at.sound_speed;
}

FlowState TaylorWave::sample(double x_over_t) const {
  if (x_over_t < rest_speed_) return rest_;
  if (x_over_t > detonation_.speed)
    return {explosive_.density, 0.0, 0.0, explosive_.specific_energy};
  double const u = detonation_.behind.velocity;
  IsentropeState const at = isentrope_.where(
      [&](IsentropeState const& s) { return u - s.velocity_change + s.sound_speed - x_over_t; });
  return {at.density, u - at.velocity_change, at.pressure, at.specific_energy};
}

}  // namespace moraine
