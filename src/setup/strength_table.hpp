// Keys of the strength of materials.
#pragma once

#include <vector>

#include "setup/binding.hpp"
#include "setup/case.hpp"

namespace moraine {

void add_strength_entries(std::vector<Entry<MaterialSpec>>& table);

}  // namespace moraine
