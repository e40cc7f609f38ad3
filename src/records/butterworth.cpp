#include "records/butterworth.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace moraine {
namespace {

constexpr double most_ringing_steps = 1e7;  // after the record: 80 MB

/// y_i = b_0 x_i + b_1 x_(i-1) + b_2 x_(i-2) - a_1 y_(i-1) - a_2 y_(i-2)
struct Section {
  double b_0, b_1, b_2, a_1, a_2;

  void apply(std::vector<double>& values) const {
    double x_1 = 0.0, x_2 = 0.0, y_1 = 0.0, y_2 = 0.0;
    for (double& value : values) {
      double const x = value;
      value = b_0 * x + b_1 * x_1 + b_2 * x_2 - a_1 * y_1 - a_2 * y_2;
      x_2 = std::exchange(x_1, x);
      y_2 = std::exchange(y_1, value);
    }
  }
};

/// The sections of a filter: a pair of poles each, and a single one where the order is odd.
std::vector<Section> sections_of(Butterworth const& filter, double time_step) {
  double const k = std::tan(std::numbers::pi * filter.corner * time_step);
  bool const low = filter.passband == Passband::low;
  std::vector<Section> sections;
  for (int pair = 0; pair < filter.order / 2; ++pair) {
    double const angle = (2.0 * pair + 1.0) * std::numbers::pi / (2.0 * filter.order);
    double const damping = 2.0 * std::sin(angle) * k;
    double const scale = 1.0 / (1.0 + damping + k * k);
    double const b = (low ? k * k : 1.0) * scale;
    sections.push_back({b, low ? 2.0 * b : -2.0 * b, b, 2.0 * (k * k - 1.0) * scale,
                        (1.0 - damping + k * k) * scale});
  }
  if (filter.order % 2 == 1) {
    double const b = (low ? k : 1.0) / (1.0 + k);
    sections.push_back({b, low ? b : -b, 0.0, (k - 1.0) / (k + 1.0), 0.0});
  }
  return sections;
}

/// Steps, times the corner and the time step, in which the slowest pole falls below 1e-12.
double ringing_cycles(int order) {
  return 28.0 / (2.0 * std::numbers::pi * std::sin(std::numbers::pi / (2.0 * order)));
}

}  // namespace

GroundRecord filtered(GroundRecord record, Butterworth const& filter) {
  check_record(record);
  if (filter.order < 1 || filter.order > 8)
    throw std::invalid_argument("Butterworth filter: the order must be 1 to 8");
  double const cycles = ringing_cycles(filter.order);
  double const lowest = cycles / (most_ringing_steps * record.time_step);
  double const highest = 0.5 / record.time_step;
  if (!(filter.corner >= lowest && filter.corner < highest))
    throw std::invalid_argument(fmt::format(
        "Butterworth filter: the corner, {:.4g} Hz, must lie between {:.2g} Hz and half "
        "of one over the time step, {:.4g} Hz",
        filter.corner, lowest, highest));
  std::vector<double>& values = record.acceleration;
  std::size_t const count = values.size();
  bool const back = filter.passes == Passes::both_ways;
  if (back)
    values.resize(
        count + static_cast<std::size_t>(std::ceil(cycles / (filter.corner * record.time_step))),
        0.0);
  auto const sections = sections_of(filter, record.time_step);
  for (Section const& section : sections) section.apply(values);
  if (back) {
    std::reverse(values.begin(), values.end());
    for (Section const& section : sections) section.apply(values);
    std::reverse(values.begin(), values.end());
    values.resize(count);
  }
  return record;
}

}  // namespace moraine
