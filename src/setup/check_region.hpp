// What the shapes, layers and starts of a region must fulfil beyond their single values.
#pragma once

#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reads the STL files of a region, makes normals unit vectors, and reports what is wrong with its
/// shapes, layers and rotation: boxes without extent, normals and cylinders of no length, polygons
/// that meet themselves, shapes and keys that the dimension does not have, STL files that cannot be
/// read or do not close a body, layers without materials or that need gravity along an axis.
/// `key` is the full key of the region with a dot behind it. Values with a reported mistake are
/// left out.
void check_geometry(RegionSpec& region, std::string const& key, Case const& c, Source& source);

/// Reports shapes of a region that reach beyond the domain, apart from the region's own box.
void check_reach(RegionSpec const& region, std::string const& key, Case const& c, Source& source);

}  // namespace moraine
