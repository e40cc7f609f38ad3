// How much solid there is around a dummy particle.
#pragma once

#include "walls/box_wall.hpp"
#include "walls/dummy_layer.hpp"

namespace moraine {

/// Radius [m] of a ball about a dummy in which there is nothing but solid: it reaches neither to a
/// face, nor to the rim of an open side, nor behind the layers of dummies. A particle inside of it
/// is in the wall for sure, by more than depth - distance behind the face, whatever the shape of
/// the wall is around. `thickness` [m] of the layers: their number times the spacing.
double clearance(BoxWall const& wall, double thickness, Dummy const& dummy);

}  // namespace moraine
