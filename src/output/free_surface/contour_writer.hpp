// Surfaces for ParaView.
#pragma once

#include <filesystem>

#include "output/free_surface/contour.hpp"

namespace moraine {

/// Writes a contour as VTK XML PolyData: raw appended data, little endian, UInt64 block headers;
/// triangles as Polys, lines as Lines, unit normals as point data (Float32), TimeValue [s]. The
/// file appears complete or not at all; throws OutputError.
void write_contour(std::filesystem::path const& path, Contour const& contour, double time);

}  // namespace moraine
