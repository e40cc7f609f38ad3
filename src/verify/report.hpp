// Results of checks as text for people and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "verify/check.hpp"

namespace moraine {

enum class Colour { none, terminal };

/// Aligned lines, one per result: verdict, name, measured, reference, tolerance, unit, note; of
/// what is known the page that explains it; of what was skipped the name and the reason.
std::string results_table(std::span<CheckResult const> results, Colour colour);

/// A list of objects with the members of CheckResult as keys, and "known"; what is not a number is
/// null.
nlohmann::ordered_json to_json(std::span<CheckResult const> results);

/// "12 of 14 results pass", and the names of those that do not, of those that do not and are known,
/// and of those that were skipped.
std::string summary(std::span<CheckResult const> results);

}  // namespace moraine
