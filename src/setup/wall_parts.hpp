// The particles of a case's walls, and which of them belong to a part of a wall.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/wall_probe.hpp"
#include "setup/case.hpp"
#include "walls/dummy_layer.hpp"
#include "walls/wall_face.hpp"

namespace moraine {

/// The faces of one wall without dummies; none of one with them. Errors as make_wall_dummies.
std::vector<WallFace> faces_of_wall(Case const& c, std::size_t wall);

/// The dummy particles of one wall, none where its method has no dummies, in the order in which
/// build_model adds them to a model. Throws std::invalid_argument as make_dummy_layer does.
std::vector<Dummy> make_wall_dummies(Case const& c, WallSpec const& wall, std::uint32_t surface);

/// Radius [m] of a ball of nothing but solid about a dummy of a wall; see walls/clearance.hpp.
double wall_clearance(Case const& c, WallSpec const& wall, Dummy const& dummy);

/// Which wall particles of the whole case a gauge of kind `wall` measures: 1 or 0, in the order of
/// WallData::points. A particle belongs to the part when the place of the wall's faces that is
/// nearest to it lies in the part's box, at the start of the run.
std::vector<std::uint8_t> wall_members(Case const& c, GaugeSpec const& gauge);

/// The faces without dummy particles that a gauge of kind `wall` measures, by their index in the
/// faces of the whole case. Spots stand for squares of about the spacing.
std::vector<FacePart> face_parts(Case const& c, GaugeSpec const& gauge);

/// Throws InputErrors for gauges whose part of a wall holds no place of it.
void check_wall_parts(Case const& c);

}  // namespace moraine
