// A key of a case, named by its path: "resolution.spacing", "region.charge.disc.radius".
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "setup/case.hpp"
#include "setup/parameter.hpp"

namespace moraine {

/// A key, and where it belongs. Materials and the elements of lists are named by their names.
struct CaseKey {
  std::string path;  // "region.charge.disc.radius"
  Section section = Section::top;
  std::string item;   // "charge"; empty at the top
  std::string inner;  // "disc.radius"
  Parameter const* parameter = nullptr;
};

/// Why there is no such key; as in InputProblem.
struct KeyMistake {
  std::string rule;
  std::string hint;
};

/// The key of this path in a case. Names may hold dots and blanks ("gauge.15 cm.position"): the
/// longest name of the case that fits counts. Of keys that exist for several choices, such as the
/// constants of equations of state, the one that the case uses is meant. Names of regions, walls,
/// gauges and stages are no keys here, since paths and results go by them.
std::variant<CaseKey, KeyMistake> find_key(std::string_view path, Case const& c);

}  // namespace moraine
