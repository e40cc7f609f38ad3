// The table of parameters: layers of a region, and how its particles start beyond single values.
#pragma once

#include <vector>

#include "setup/binding.hpp"
#include "setup/case.hpp"

namespace moraine {

/// Keys of Layers.
void add_layer_entries(std::vector<Entry<RegionSpec>>& table);

/// Keys of the rotation and of the lithostatic start.
void add_start_entries(std::vector<Entry<RegionSpec>>& table);

/// Keys of a lattice of the region's own.
void add_spacing_entries(std::vector<Entry<RegionSpec>>& table);

}  // namespace moraine
