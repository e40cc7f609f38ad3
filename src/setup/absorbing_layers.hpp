// Absorbing layers of a model.
#pragma once

#include "setup/case.hpp"
#include "step/model.hpp"

namespace moraine {

/// The ends are those of the particles, half a spacing beyond their places; explosives have none
/// and do not fade. What begins in a layer gets its rest density, all else none. After all fluid
/// particles have been added.
void add_absorbing_layers(Case const& c, Model& model);

}  // namespace moraine
