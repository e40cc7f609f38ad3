// Fields on a regular grid for ParaView.
#pragma once

#include <filesystem>
#include <vector>

#include "probes/grid_probe.hpp"

namespace moraine {

/// Writes states at the points of a grid as VTK XML ImageData: raw appended data, little endian,
/// UInt64 block headers. Point data: pressure, density, specific_energy, velocity (Float32, SI,
/// with the unit as in frames; not a number where no particle is near) and valid (UInt8: 1 where
/// one is). FieldData: TimeValue [s]. `states` in the order of the grid. The file appears complete
/// or not at all; throws OutputError.
void write_vti(std::filesystem::path const& path, PlaceGrid const& grid,
               std::vector<PointState> const& states, double time);

}  // namespace moraine
