// What a table of conserved sums says about a run.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "output/table_csv.hpp"

namespace moraine {

/// A quantity that should be conserved: by how much it is not at worst, and what that is measured
/// by.
struct Drift {
  double largest = 0.0;  // of |what it should be - what it is| over the rows
  double scale = 0.0;
  /// largest / scale; 0 where both are; not a number where a sum is none.
  double share() const;
};

/// Energy that nobody booked [J], by the largest change of kinetic, internal or potential energy
/// since the start. Nothing where the table has no rows or lacks a column.
std::optional<Drift> energy_drift(Table const& sums);

/// Momentum that neither walls nor gravity [m/s^2] gave [kg m/s], the largest component of those
/// that `axes` names, by the momentum sqrt(2 m E_kin) of the largest kinetic energy.
std::optional<Drift> momentum_drift(Table const& sums, std::array<double, 3> const& gravity,
                                    std::array<bool, 3> const& axes = {true, true, true});

/// The last value of a column; nothing where there is none.
std::optional<double> last_of(Table const& sums, std::string_view column);

}  // namespace moraine
