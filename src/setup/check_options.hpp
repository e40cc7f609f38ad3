// Rules of the optional pair terms.
#pragma once

#include <vector>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports a viscosity that no material has, and a penalty that would attract.
void check_options(Case const& c, Source& source);

/// Warns of options that have nothing to do, and of those that do not suit the case.
void add_option_warnings(Case const& c, std::vector<InputProblem>& warnings);

}  // namespace moraine
