// The table of parameters: [guards].
#pragma once

#include <vector>

#include "setup/binding.hpp"
#include "setup/case.hpp"

namespace moraine {

/// Appends the keys of the table [guards].
void add_guards(std::vector<Entry<Case>>& table);

}  // namespace moraine
