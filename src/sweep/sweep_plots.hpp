// Pictures of a sweep: outputs over parameters.
#pragma once

#include <filesystem>
#include <vector>

#include "sweep/sweep_plan.hpp"
#include "sweep/sweep_table.hpp"

namespace moraine {

/// Draws one PNG for each axis of the plan with more than one value, a panel for each output:
/// numbers along a linear or logarithmic axis, words side by side. Members that differ in nothing
/// else are joined by a line, of one colour for all of the same other values; drawn members are
/// points only. Returns the files, `FOLDER/sweep_LABEL.png`; none without outputs or results.
/// Throws std::runtime_error if one cannot be written.
std::vector<std::filesystem::path> plot_sweep(SweepPlan const& plan, SweepTable const& table,
                                              std::filesystem::path const& folder);

}  // namespace moraine
