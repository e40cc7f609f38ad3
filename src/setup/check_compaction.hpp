// Rules of materials with pores.
#pragma once

#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports constants of `p_alpha` that do not belong together; `key` is "material.NAME.".
void check_compaction(MaterialSpec const& material, std::string const& key, Source& source);

}  // namespace moraine
