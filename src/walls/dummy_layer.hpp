// Dummy particles of a fixed box wall: layers of particles behind its faces.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface/face_geometry.hpp"
#include "walls/box_wall.hpp"

namespace moraine {

/// A particle that stands for the solid behind a face in sums over neighbours.
struct Dummy {
  std::array<double, 3> position;  // m
  /// Unit normal into the fluid. Zero where the wall has none to offer: the nearest place of the
  /// wall is an edge or a corner, or two sides are equally near.
  std::array<double, 3> normal;
  std::uint32_t surface;  // as given by the caller
  std::uint32_t face;     // of make_box_surface
  FaceCoordinates uv;     // Surface::sample(face, uv, depth) is this particle
  double depth;           // m, behind the plane of that face
};

/// Dummies of a wall on a lattice of spacing `spacing` [m], in the order x fastest, z slowest.
///
/// The first layer is half a spacing behind its side, as the first fluid particles are in front of
/// it; there are `layers` of them.
/// Solid outside (a tank): along the sides the lattice starts half a spacing from the lower corner,
/// like the particles that fill the tank; the blocks behind the edges between two closed sides are
/// filled, and nothing stands beyond the rim of an open side. Where the box's length is not a whole
/// number of spacings, the gap (by up to half a spacing) is at the inner corner of the plus side.
/// Solid inside (an obstacle): from half a spacing behind one side to half a spacing behind the
/// other the lattice is even, with the whole number of intervals that comes nearest to `spacing`.
/// Along a periodic axis that the wall spans, the period is divided evenly in the same way, so that
/// the seam shows neither a gap nor a duplicate.
///
/// Throws std::invalid_argument as `check` does, for a spacing or a number of layers that is not
/// positive, and for a box thinner than one spacing.
std::vector<Dummy> make_dummy_layer(BoxWall const& wall, double spacing, int layers,
                                    std::uint32_t surface);

}  // namespace moraine
