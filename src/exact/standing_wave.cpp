#include "exact/standing_wave.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moraine {

void StandingWave::check() const {
  if (!(wave_length > 0.0 && depth > 0.0 && gravity > 0.0 && density > 0.0))
    throw std::invalid_argument(
        "standing wave: wave length, depth, gravity and density must be positive");
  if (!(kinematic_viscosity >= 0.0))
    throw std::invalid_argument("standing wave: the viscosity must not be negative");
}

double StandingWave::wave_number() const { return 2.0 * std::numbers::pi / wave_length; }

double StandingWave::angular_frequency() const {
  double const k = wave_number();
  return std::sqrt(gravity * k * std::tanh(k * depth));
}

double StandingWave::period() const { return 2.0 * std::numbers::pi / angular_frequency(); }

double StandingWave::decay_rate() const {
  return 2.0 * kinematic_viscosity * wave_number() * wave_number();
}

double StandingWave::elevation(double x, double time) const {
  return amplitude * std::cos(wave_number() * x) * std::cos(angular_frequency() * time) *
         std::exp(-decay_rate() * time);
}

StandingWave::Sample StandingWave::sample(double x, double z, double time) const {
  double const k = wave_number();
  double const w = angular_frequency();
  double const decayed = amplitude * std::exp(-decay_rate() * time);
  // cosh(k(z+d))/cosh(kd) and the same with sinh, without overflow on deep liquid.
  double const down = std::exp(-2.0 * k * (z + depth));
  double const scale = std::exp(k * z) / (1.0 + std::exp(-2.0 * k * depth));
  double const even = scale * (1.0 + down);
  double const odd = scale * (1.0 - down);
  double const speed = decayed * gravity * k / w * std::sin(w * time);
  return {speed * even * std::sin(k * x), -speed * odd * std::cos(k * x),
          density * gravity * (decayed * even * std::cos(k * x) * std::cos(w * time) - z)};
}

double StandingWave::energy() const {
  return 0.25 * density * gravity * amplitude * amplitude * wave_length;
}

}  // namespace moraine
