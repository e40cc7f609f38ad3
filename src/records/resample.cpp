#include "records/resample.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace moraine {
namespace {

constexpr double beta = 10.0;       // of the Kaiser window
constexpr double crossings = 32.0;  // of zero, to each side

double sinc(double x) {
  double const angle = std::numbers::pi * x;
  return std::fabs(angle) < 1e-8 ? 1.0 : std::sin(angle) / angle;
}

/// sinc under the window, up to a factor; x counts zero crossings.
double kernel(double x) {
  double const relative = x / crossings;
  if (std::fabs(relative) >= 1.0) return 0.0;
  return sinc(x) * std::cyl_bessel_i(0.0, beta * std::sqrt(1.0 - relative * relative));
}

/// The value at `place`, counted in old steps; `rate` zero crossings per old step.
double band_limited_value(std::vector<double> const& values, double place, double rate) {
  double const reach = crossings / rate;
  auto const last = static_cast<double>(values.size() - 1);
  auto const from = static_cast<std::size_t>(std::max(0.0, std::ceil(place - reach)));
  auto const to = static_cast<std::size_t>(std::min(last, std::floor(place + reach)));
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = from; i <= to; ++i) {
    double const weight = kernel(rate * (place - static_cast<double>(i)));
    sum += weight * values[i];
    weights += weight;
  }
  return sum / weights;
}

double linear_value(std::vector<double> const& values, double place) {
  auto const i = std::min(values.size() - 2, static_cast<std::size_t>(place));
  double const part = place - static_cast<double>(i);
  return values[i] + part * (values[i + 1] - values[i]);
}

}  // namespace

GroundRecord resampled(GroundRecord const& record, double time_step, Interpolation interpolation) {
  check_record(record);
  double const ratio = time_step / record.time_step;
  auto const last = static_cast<double>(record.size() - 1);
  if (!(ratio > 0.0) || !(last / ratio * (1.0 + 1e-12) >= 1.0))
    throw std::invalid_argument("resampling: the step must be positive and fit into the record");
  if (!(last / ratio < 1e7))
    throw std::invalid_argument("resampling: more than ten million values");
  bool const coarser = ratio > 1.0 + 1e-9;
  if (coarser && interpolation == Interpolation::linear)
    throw std::invalid_argument("resampling: straight lines are for finer steps only");
  auto const count = static_cast<std::size_t>(last / ratio * (1.0 + 1e-12)) + 1;
  GroundRecord result{record.name, time_step, record.start, std::vector<double>(count)};
  double const rate = coarser ? 0.9 / ratio : 1.0;
  for (std::size_t i = 0; i < count; ++i) {
    double const place = std::min(last, static_cast<double>(i) * ratio);
    result.acceleration[i] = interpolation == Interpolation::linear
                                 ? linear_value(record.acceleration, place)
                                 : band_limited_value(record.acceleration, place, rate);
  }
  return result;
}

}  // namespace moraine
