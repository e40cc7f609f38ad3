// The table of parameters: how an explosive burns.
#pragma once

#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {

/// Adds the keys burn.* of a material.
void add_burn_entries(std::vector<Entry<MaterialSpec>>& table);

}  // namespace moraine
