// The table of parameters: optional pair terms.
#pragma once

#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {

void add_options(std::vector<Entry<Case>>& table);

}  // namespace moraine
