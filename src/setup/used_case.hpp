// The case that a run really uses.
#pragma once

#include <string>

#include "setup/case.hpp"

namespace moraine {

/// The case as TOML with every default filled in and all numbers in SI, units as comments. Reading
/// it gives the same Case, to the bit, apart from Case::file.
std::string used_case(Case const& c);

}  // namespace moraine
