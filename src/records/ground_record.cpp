#include "records/ground_record.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace moraine {
namespace {

// s; squares and products with values stay numbers.
constexpr double latest_time = 1e12;

}  // namespace

void check_record(GroundRecord const& record) {
  if (record.size() < 2)
    throw std::invalid_argument("ground record: it must have two values or more");
  if (!(record.time_step > 0.0) || !std::isfinite(record.time_step))
    throw std::invalid_argument("ground record: the time step must be positive");
  if (!(std::fabs(record.time(record.size() - 1)) < latest_time))
    throw std::invalid_argument("ground record: it must end before 1e12 s");
  for (double const a : record.acceleration)
    if (!std::isfinite(a)) throw std::invalid_argument("ground record: a value is not finite");
}

Peak peak_of(GroundRecord const& record, std::vector<double> const& values) {
  auto const smaller = [](double a, double b) { return std::fabs(a) < std::fabs(b); };
  auto const largest = std::max_element(values.begin(), values.end(), smaller);
  return {std::fabs(*largest), record.time(static_cast<std::size_t>(largest - values.begin()))};
}

GroundRecord scaled_to_peak(GroundRecord record, double peak) {
  if (!(peak > 0.0) || !std::isfinite(peak))
    throw std::invalid_argument("scaled record: the peak must be positive");
  double const found = peak_of(record, record.acceleration).value;
  if (found == 0.0) throw std::invalid_argument("scaled record: it is zero throughout");
  // Divided first, so that the largest value becomes the peak to the last bit.
  for (double& a : record.acceleration) a = a / found * peak;
  return record;
}

GroundRecord time_scaled(GroundRecord record, double factor) {
  if (!(factor > 0.0) || !std::isfinite(factor))
    throw std::invalid_argument("time scale: the factor must be positive");
  record.time_step *= factor;
  record.start *= factor;
  return record;
}

GroundRecord cut_after(GroundRecord record, double end) {
  double const steps = std::floor((end - record.start) / record.time_step * (1.0 + 1e-12) + 1e-9);
  if (!(steps >= 1.0)) throw std::invalid_argument("cut record: fewer than two values are left");
  auto const left = std::min(static_cast<double>(record.size()), steps + 1.0);
  record.acceleration.resize(static_cast<std::size_t>(left));
  return record;
}

GroundPath integrate(GroundRecord const& record) {
  std::vector<double> const& a = record.acceleration;
  double const dt = record.time_step;
  GroundPath path{std::vector<double>(a.size()), std::vector<double>(a.size())};
  for (std::size_t i = 1; i < a.size(); ++i) {
    path.velocity[i] = path.velocity[i - 1] + 0.5 * dt * (a[i - 1] + a[i]);
    path.displacement[i] = path.displacement[i - 1] + dt * path.velocity[i - 1] +
                           dt * dt / 6.0 * (2.0 * a[i - 1] + a[i]);
  }
  return path;
}

}  // namespace moraine
