// What the gauges of a case read while it runs in memory.
#pragma once

#include "output/table_csv.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// Advances a simulation of this case to its end and returns the table that `moraine run` would
/// write to gauges.csv: readings at the start, at the interval that the case asks for, and at the
/// end.
Table read_gauges(Simulation& simulation, Case const& c);

/// The column of this name. Throws std::invalid_argument where the table has none.
std::vector<double> const& column(Table const& table, std::string_view name);

}  // namespace moraine
