// Answers and the list of relations as text.
#pragma once

#include <span>
#include <string>

#include "blast/estimate.hpp"
#include "output/blast/gauge_readings.hpp"
#include "output/blast/output_units.hpp"

namespace moraine::blast {

/// One block per measure: the relations with value, scatter and standing, marks where a warning
/// belongs, the spread, and the reading of a gauge beside the first recommended relation; then the
/// warnings by mark, what the relations assume, and what was not answered.
std::string answer_text(Answer const& answer, OutputUnits const& units,
                        GaugeReadings const& gauge = {});

/// Name, formula, source, range and standing of each relation.
std::string list_text(std::span<Relation const> relations);

}  // namespace moraine::blast
