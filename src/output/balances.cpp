#include "output/balances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace moraine {
namespace {

using Column = std::vector<double>;

/// The columns with these names; none where one is missing or there are no rows.
template <std::size_t count>
std::optional<std::array<Column const*, count>> columns(
    Table const& table, std::array<char const*, count> const& names) {
  std::array<Column const*, count> found{};
  for (std::size_t i = 0; i < count; ++i)
    if ((found[i] = table.find(names[i])) == nullptr || found[i]->empty()) return std::nullopt;
  return found;
}

/// Not a number where any value is none: such a sum is not conserved, whatever the others say.
double largest_change(Column const& values) {
  double largest = 0.0;
  for (double const value : values) {
    if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
    largest = std::max(largest, std::abs(value - values.front()));
  }
  return largest;
}

/// The larger one; what is no number stays.
double larger(double a, double b) { return std::isnan(a) || b <= a ? a : b; }

}  // namespace

double Drift::share() const {
  if (std::isnan(largest) || std::isnan(scale)) return std::numeric_limits<double>::quiet_NaN();
  if (scale > 0.0) return largest / scale;
  return largest > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

std::optional<Drift> energy_drift(Table const& sums) {
  auto const found = columns<6>(sums, {"total_energy", "lost_energy", "wall_work", "damping_work",
                                       "detonation_energy", "drift_work"});
  auto const kinds = columns<3>(sums, {"kinetic_energy", "internal_energy", "potential_energy"});
  if (!found || !kinds) return std::nullopt;
  auto const& [total, lost, walls, damping, detonation, drift] = *found;
  Column balance;
  for (std::size_t row = 0; row < total->size(); ++row)
    balance.push_back((*total)[row] + (*lost)[row] - (*walls)[row] - (*damping)[row] -
                      (*detonation)[row] - (*drift)[row]);
  Drift result;
  result.largest = largest_change(balance);
  for (Column const* kind : *kinds) result.scale = larger(result.scale, largest_change(*kind));
  return result;
}

std::optional<Drift> momentum_drift(Table const& sums, std::array<double, 3> const& gravity,
                                    std::array<bool, 3> const& told) {
  auto const state = columns<3>(sums, {"time", "mass", "kinetic_energy"});
  if (!state) return std::nullopt;
  auto const& [time, mass, kinetic] = *state;
  Drift result;
  for (std::size_t row = 0; row < time->size(); ++row)
    result.scale = larger(result.scale, std::sqrt(2.0 * (*mass)[row] * (*kinetic)[row]));
  constexpr std::array<char, 3> axes{'x', 'y', 'z'};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!told[axis]) continue;
    std::string const momentum_name = std::string("momentum_") + axes[axis];
    std::string const impulse_name = std::string("wall_impulse_") + axes[axis];
    auto const found = columns<2>(sums, {momentum_name.c_str(), impulse_name.c_str()});
    if (!found) return std::nullopt;
    auto const& [momentum, impulse] = *found;
    Column balance;
    for (std::size_t row = 0; row < time->size(); ++row)
      balance.push_back((*momentum)[row] - (*impulse)[row] -
                        (*mass)[row] * gravity[axis] * (*time)[row]);
    result.largest = larger(result.largest, largest_change(balance));
  }
  return result;
}

std::optional<double> last_of(Table const& sums, std::string_view column) {
  Column const* const found = sums.find(column);
  if (found == nullptr || found->empty()) return std::nullopt;
  return found->back();
}

}  // namespace moraine
