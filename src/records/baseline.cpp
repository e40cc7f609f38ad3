#include "records/baseline.hpp"

#include <numeric>
#include <stdexcept>
#include <vector>

namespace moraine {
namespace {

double dot(std::vector<double> const& a, std::vector<double> const& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

void subtract(std::vector<double>& values, double factor, std::vector<double> const& other) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i] -= factor * other[i];
}

/// Takes from the values their projections on 1, x, x^2, ... with x from -1 to 1, each made
/// orthogonal to those before it (Gram-Schmidt).
void remove_polynomial(std::vector<double>& values, std::size_t degree) {
  if (values.size() <= degree)
    throw std::invalid_argument("baseline: the record is too short for this polynomial");
  double const middle = 0.5 * static_cast<double>(values.size() - 1);
  std::vector<std::vector<double>> basis;
  for (std::size_t k = 0; k <= degree; ++k) {
    std::vector<double> next(values.size(), 1.0);
    for (std::size_t i = 0; k > 0 && i < next.size(); ++i)
      next[i] = basis[k - 1][i] * (static_cast<double>(i) - middle) / middle;
    for (auto const& earlier : basis)
      subtract(next, dot(next, earlier) / dot(earlier, earlier), earlier);
    subtract(values, dot(values, next) / dot(next, next), next);
    basis.push_back(std::move(next));
  }
}

/// a - c_0 - c_1 (t - t_0) with c_0 T + c_1 T^2/2 = v(T) and c_0 T^2/2 + c_1 T^3/6 = d(T).
void bring_to_rest(GroundRecord& record) {
  GroundPath const path = integrate(record);
  double const duration = record.duration();
  double const v = path.velocity.back(), d = path.displacement.back();
  double const slope = 12.0 * (0.5 * v - d / duration) / (duration * duration);
  double const offset = v / duration - 0.5 * slope * duration;
  for (std::size_t i = 0; i < record.size(); ++i)
    record.acceleration[i] -= offset + slope * static_cast<double>(i) * record.time_step;
}

}  // namespace

GroundRecord baseline_corrected(GroundRecord record, Baseline baseline) {
  check_record(record);
  if (baseline == Baseline::rest)
    bring_to_rest(record);
  else if (baseline != Baseline::none)
    remove_polynomial(record.acceleration, static_cast<std::size_t>(baseline) -
                                               static_cast<std::size_t>(Baseline::mean));
  return record;
}

}  // namespace moraine
