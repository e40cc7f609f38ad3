// What absorbing layers must say.
#pragma once

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

void check_absorbing(Case const& c, Source& source);

}  // namespace moraine
