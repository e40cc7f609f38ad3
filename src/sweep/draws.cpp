#include "sweep/draws.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <utility>

namespace moraine {
namespace {

double rounded(double value) { return std::strtod(fmt::format("{:.12g}", value).c_str(), nullptr); }

/// In [0, 1): the upper 53 bits, as many as a double holds.
double unit_draw(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11U) * 0x1p-53;
}

/// Fisher and Yates, from the end. The standard does not say what std::shuffle does.
std::vector<std::size_t> permutation(std::size_t size, std::mt19937_64& generator) {
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t last = size; last > 1; --last)
    std::swap(order[last - 1], order[static_cast<std::size_t>(generator() % last)]);
  return order;
}

}  // namespace

double ValueRange::at(double share) const {
  if (logarithmic) return rounded(low * std::pow(high / low, share));
  return rounded(low + share * (high - low));
}

std::vector<double> even_values(ValueRange const& range, std::size_t steps) {
  if (steps == 1) return {range.at(0.5)};
  std::vector<double> values;
  for (std::size_t i = 0; i < steps; ++i)
    values.push_back(range.at(static_cast<double>(i) / static_cast<double>(steps - 1)));
  return values;
}

std::size_t value_at(double place, std::size_t count) {
  // The last of the draws may be rounded up to 1.
  return std::min(static_cast<std::size_t>(place * static_cast<double>(count)), count - 1);
}

std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t samples,
                                                 std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::vector<std::vector<double>> points;
  for (std::size_t d = 0; d < dimensions; ++d) {
    std::vector<double> row;
    for (std::size_t const stratum : permutation(samples, generator))
      row.push_back((static_cast<double>(stratum) + unit_draw(generator)) /
                    static_cast<double>(samples));
    points.push_back(std::move(row));
  }
  return points;
}

}  // namespace moraine
