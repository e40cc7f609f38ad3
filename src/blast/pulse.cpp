#include "blast/pulse.hpp"

#include <cmath>

#include "base/bisect.hpp"

namespace moraine::blast {
namespace {

/// Impulse of a Friedlander pulse over p t_0.
double impulse_share(double k) {
  if (k < 1e-3) return 0.5 - k / 6.0 + k * k / 24.0;  // next term below 1e-11
  return 1.0 / k + std::expm1(-k) / (k * k);
}

}  // namespace

double triangle_pulse(double peak, double duration, double time) {
  return time >= 0.0 && time <= duration ? peak * (1.0 - time / duration) : 0.0;
}

double triangle_impulse(double peak, double duration) { return 0.5 * peak * duration; }

double friedlander_pulse(double peak, double duration, double decay, double time) {
  double const t = time / duration;
  return t >= 0.0 ? peak * (1.0 - t) * std::exp(-decay * t) : 0.0;
}

double friedlander_impulse(double peak, double duration, double decay) {
  return peak * duration * impulse_share(decay);
}

double friedlander_suction(double peak, double duration, double decay) {
  return friedlander_pulse(peak, duration, decay, duration * (1.0 + 1.0 / decay));
}

std::optional<double> friedlander_decay(double peak, double duration, double impulse) {
  double const share = impulse / (peak * duration);
  if (!(share > 0.0) || share > 0.5) return std::nullopt;
  if (share == 0.5) return 0.0;
  // The share is below 1/k.
  return bisect([&](double k) { return share - impulse_share(k); }, 0.0, 1.0 / share);
}

double exponential_pulse(double peak, double time_constant, double time) {
  return time >= 0.0 ? peak * std::exp(-time / time_constant) : 0.0;
}

}  // namespace moraine::blast
