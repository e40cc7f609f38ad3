// Answers and the list of relations as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "blast/estimate.hpp"
#include "output/blast/gauge_readings.hpp"
#include "output/blast/output_units.hpp"

namespace moraine::blast {

/// {"estimates": [...], "spreads": [...], "unanswered": [...]}; numbers that do not exist are null.
/// An estimate has measure, relation, value, low, high, unit, standing, in_range, range and its
/// variable's value, warnings, formula, source and note.
nlohmann::ordered_json to_json(Answer const& answer, OutputUnits const& units);

/// {"name", "readings": [...]}: each reading with measure, value, unit, and where there is a
/// recommended relation its name and the ratio to it. Readings of measures that the answer does not
/// hold are left out.
nlohmann::ordered_json to_json(GaugeReadings const& gauge, Answer const& answer,
                               OutputUnits const& units);

nlohmann::ordered_json to_json(std::span<Relation const> relations);

}  // namespace moraine::blast
