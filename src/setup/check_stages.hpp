// What the stages of a case must fulfil beyond their single values.
#pragma once

#include <string>
#include <vector>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports names of walls, regions, materials and gauges that the case does not have, conditions
/// with a part missing, and a stage that never ends although others follow. `keys`: of the stages.
void check_stages(Case const& c, std::vector<std::string> const& keys, Source& source);

}  // namespace moraine
