// The particles of a case's walls, and which of them belong to a part of a wall.
#pragma once

#include <cstdint>
#include <vector>

#include "setup/case.hpp"
#include "walls/dummy_layer.hpp"

namespace moraine {

/// The dummy particles of one wall, in the order in which build_model adds them to a model.
/// Throws std::invalid_argument as make_dummy_layer does.
std::vector<Dummy> make_wall_dummies(Case const& c, WallSpec const& wall, std::uint32_t surface);

/// Radius [m] of a ball of nothing but solid about a dummy of a wall; see walls/clearance.hpp.
double wall_clearance(Case const& c, WallSpec const& wall, Dummy const& dummy);

/// Which wall particles of the whole case a gauge of kind `wall` measures: 1 or 0, in the order of
/// WallData::points. A particle belongs to the part when the place of the wall's faces that is
/// nearest to it lies in the part's box, at the start of the run.
std::vector<std::uint8_t> wall_members(Case const& c, GaugeSpec const& gauge);

/// Throws InputErrors for gauges whose part of a wall holds no place of it.
void check_wall_parts(Case const& c);

}  // namespace moraine
