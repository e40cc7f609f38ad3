// What absorbing layers must say.
#pragma once

#include <vector>

#include "setup/case.hpp"
#include "setup/source.hpp"
#include "step/model.hpp"

namespace moraine {

void check_absorbing(Case const& c, Source& source);

/// Doubts: layers that take most of the material, gauges and explosives within them.
void add_absorbing_warnings(Case const& c, Model const& model, std::vector<InputProblem>& warnings);

}  // namespace moraine
