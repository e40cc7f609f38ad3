// The case that a run really uses.
#pragma once

#include <string>

#include "setup/case.hpp"

namespace moraine {

/// The case as TOML with every default filled in and all numbers in SI, units as comments. Reading
/// it gives the same Case, to the bit, apart from Case::file.
std::string used_case(Case const& c);

/// The constants of one material as lines of its table there, in the same way.
std::string material_constants(Case const& c, MaterialSpec const& material);

}  // namespace moraine
