// Answers and the list of relations as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "blast/estimate.hpp"
#include "output/blast/output_units.hpp"

namespace moraine::blast {

/// {"estimates": [...], "spreads": [...], "unanswered": [...]}; numbers that do not exist are null.
/// An estimate has measure, relation, value, low, high, unit, standing, in_range, range and its
/// variable's value, warnings, formula, source and note.
nlohmann::ordered_json to_json(Answer const& answer, OutputUnits const& units);

nlohmann::ordered_json to_json(std::span<Relation const> relations);

}  // namespace moraine::blast
