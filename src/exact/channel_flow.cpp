#include "exact/channel_flow.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;

void check_channel(double width, double viscosity) {
  if (!(width > 0.0)) throw std::invalid_argument("channel: the width must be positive");
  if (!(viscosity > 0.0)) throw std::invalid_argument("channel: the viscosity must be positive");
}

// Beyond this term exp(-(n pi)^2 t') is below 1e-17. Times t' = nu t / L^2 below 1e-10 count as
// that: their layers are thinner than 1e-5 of the width.
int last_term(double& scaled_time) {
  scaled_time = std::fmax(scaled_time, 1e-10);
  return static_cast<int>(std::sqrt(40.0 / scaled_time) / pi) + 2;
}

}  // namespace

void CouetteFlow::check() const { check_channel(width, kinematic_viscosity); }

double CouetteFlow::steady_velocity(double y) const { return plate_speed * y / width; }

double CouetteFlow::velocity(double y, double time) const {
  if (time <= 0.0) return y < width ? 0.0 : plate_speed;
  double scaled_time = kinematic_viscosity * time / (width * width);
  double sum = 0.0;
  for (int n = last_term(scaled_time); n > 0; --n) {
    double const sign = n % 2 == 0 ? 1.0 : -1.0;
    sum +=
        sign / (n * pi) * std::sin(n * pi * y / width) * std::exp(-n * pi * n * pi * scaled_time);
  }
  return steady_velocity(y) + 2.0 * plate_speed * sum;
}

void PoiseuilleFlow::check() const { check_channel(width, kinematic_viscosity); }

double PoiseuilleFlow::steady_velocity(double y) const {
  return 0.5 * force / kinematic_viscosity * y * (width - y);
}

double PoiseuilleFlow::velocity(double y, double time) const {
  if (time <= 0.0) return 0.0;
  double scaled_time = kinematic_viscosity * time / (width * width);
  double sum = 0.0;
  for (int n = last_term(scaled_time) | 1; n > 0; n -= 2)
    sum += std::sin(n * pi * y / width) * std::exp(-n * pi * n * pi * scaled_time) /
           (n * pi * n * pi * n * pi);
  return steady_velocity(y) - 4.0 * force * width * width / kinematic_viscosity * sum;
}

}  // namespace moraine
