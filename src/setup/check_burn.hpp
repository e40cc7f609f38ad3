// Rules of burning explosives.
#pragma once

#include <string>

#include "matter/burn/burn.hpp"
#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports what is wrong with how a material burns; `key` is "material.NAME.". Fills in the speed
/// of the front and the Chapman-Jouguet volume where the case does not give them.
void check_burn(MaterialSpec& material, std::string const& key, Source& source);

/// What the step needs to know of a checked material that burns: `programmed`, with `spacing` that
/// of the case [m]. Values that are still absent are those of the material; throws
/// std::domain_error where its constants have no Chapman-Jouguet state.
Burn burn_of(MaterialSpec const& material, double spacing);

}  // namespace moraine
