// From a case to a model: particles, walls, settings.
#pragma once

#include "setup/case.hpp"
#include "step/model.hpp"

namespace moraine {

/// Fills the regions, lays dummy particles behind the walls and copies the settings. Throws
/// InputErrors for a region that fills nothing and for walls that cannot be built.
Model build_model(Case const& c);

}  // namespace moraine
