// What a time step does, for one case.
#pragma once

#include <string>

#include "setup/case.hpp"

namespace moraine {

/// The actions of a step in their order, each with its description and with what it means for this
/// case: which materials, terms and walls take part, with the values that the case gives.
std::string explain_step(Case const& c);

}  // namespace moraine
