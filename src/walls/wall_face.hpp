// A face of a wall that is not made of dummy particles: a mirror, a row of repulsive particles, or
// both.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vec3.hpp"
#include "walls/box_wall.hpp"

namespace moraine {

/// How hard and how far wall particles push; see terms/repulsion.hpp.
struct FaceRepulsion {
  double strength = 0.0;  // D [m^2/s^2]; 0: the face does not push
  double range = 0.0;     // r_0 [m]
};

/// One axis of the lattice of repulsive particles on a face: first + k step, 0 <= k < count.
struct FaceRow {
  double first = 0.0;  // m
  double step = 0.0;   // m
  int count = 1;
};

/// A flat rectangular face, perpendicular to an axis, where it is before any motion.
struct WallFace {
  static constexpr std::uint16_t at_rest = 0xFFFF;

  std::uint32_t wall = 0;   // number of the wall in the case
  std::size_t axis = 0;     // across the face
  std::size_t end = 0;      // 0: minus side of the wall's box, 1: plus side
  double fluid_sign = 1.0;  // the normal into the fluid is fluid_sign times the axis
  bool mirror = false;      // it is a side of the domain, which makes images
  Vec3 low{}, high{};       // m, corners; equal along the axis
  FaceRepulsion repulsion{};
  std::array<FaceRow, 3> rows{};  // of the repulsive particles
  std::uint16_t body = at_rest;   // which of WallData::bodies it belongs to
};

/// The closed sides of a wall. Repulsive particles stand half a `spacing` [m] apart, evenly from
/// edge to edge. An edge between two closed sides belongs to the side of the lower axis, so that no
/// particle stands twice; `goes_on` are sides of the box beyond which an open side continues, at
/// planes and periodic seams: there the lattice goes on for the range.
std::vector<WallFace> make_wall_faces(BoxWall const& wall, double spacing,
                                      FaceRepulsion const& repulsion,
                                      std::array<std::array<bool, 2>, 3> const& goes_on);

/// Calls use(x) for all repulsive particles of a face that may be nearer to `place` than its range,
/// and for a few that are not. All before any motion.
template <class Use>
void for_each_repulsive_near(WallFace const& face, int dimension, Vec3 const& place, Use&& use) {
  std::array<int, 3> low{0, 0, 0}, high{0, 0, 0};
  double const range = face.repulsion.range;
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    FaceRow const& row = face.rows[k];
    if (k == face.axis) {
      if (std::fabs(place[k] - row.first) >= range) return;
      continue;
    }
    double const from = (place[k] - range - row.first) / row.step;
    double const to = (place[k] + range - row.first) / row.step;
    if (!(to >= 0.0 && from <= row.count - 1)) return;
    low[k] = from > 0.0 ? static_cast<int>(from) : 0;
    high[k] = to < row.count - 1 ? static_cast<int>(to) : row.count - 1;
  }
  Vec3 x{};
  for (int c = low[2]; c <= high[2]; ++c)
    for (int b = low[1]; b <= high[1]; ++b)
      for (int a = low[0]; a <= high[0]; ++a) {
        x = {face.rows[0].first + a * face.rows[0].step, face.rows[1].first + b * face.rows[1].step,
             face.rows[2].first + c * face.rows[2].step};
        use(x);
      }
}

/// All repulsive particles of a face before any motion, or those that would stand on it; for
/// looking at.
std::vector<Vec3> face_particles(WallFace const& face, int dimension);

}  // namespace moraine
