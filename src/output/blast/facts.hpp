// What a situation is in the variables of the field, in words.
#pragma once

#include <string>
#include <vector>

#include "blast/relation.hpp"

namespace moraine::blast {

/// Lines such as "R/W^(1/3) is 2.321 m/kg^(1/3) or 5.85 ft/lb^(1/3)"; none where inputs lack.
std::vector<std::string> facts(Topic topic, Situation const& situation, UnitSystem system);

}  // namespace moraine::blast
