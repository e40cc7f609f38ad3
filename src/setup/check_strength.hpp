// What the strength of a material must say.
#pragma once

#include <string>
#include <vector>

#include "matter/strength/strength.hpp"
#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// `key` is the path of the material with a dot behind it, for messages.
void check_strength(MaterialSpec const& material, std::string const& key, Source& source);

/// Doubtful strengths, for `moraine check`.
void add_strength_warnings(Case const& c, std::vector<InputProblem>& warnings);

/// The law that a checked spec says.
Strength strength_of(StrengthSpec const& spec);

}  // namespace moraine
