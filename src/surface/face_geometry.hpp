// Geometry of one face: a point in 1D, a segment in 2D, a triangle in 3D.
#pragma once

#include <array>

#include "base/vec3.hpp"

namespace moraine {

/// The corners of a face, or their velocities; the first `dimension` entries count.
using Corners = std::array<Vec3, 3>;

/// Place on a face: x = (1 - u - v) x_0 + u x_1 + v x_2, with v = 0 in 2D, u = v = 0 in 1D. Values
/// outside the face continue its plane.
using FaceCoordinates = std::array<double, 2>;

/// Shares of the corners at a place on the face; they add up to one.
inline std::array<double, 3> shape_functions(FaceCoordinates const& uv) {
  return {1.0 - uv[0] - uv[1], uv[0], uv[1]};
}

/// Normal whose length is that of the segment, or twice the area of the triangle [m, m^2]: to the
/// left of x_0 -> x_1 in 2D, right-handed about x_0, x_1, x_2 in 3D, along +x in 1D (length 1).
Vec3 area_normal(int dimension, Corners const& corners);

/// Rate of area_normal while the corners move with these velocities.
Vec3 area_normal_rate(int dimension, Corners const& corners, Corners const& velocities);

/// The point of a face that is nearest to some place.
struct NearestOnFace {
  Vec3 position;
  FaceCoordinates uv;
  double angle;  // rad, of the face's interior seen from there: 2 pi inside, pi on an edge, ...
};

/// Nearest point of the face to `point`. In 1D and 2D the angle is one for every face.
/// Triangle: Ericson, Real-Time Collision Detection (2005), section 5.1.5.
NearestOnFace nearest_on_face(int dimension, Corners const& corners, Vec3 const& point);

}  // namespace moraine
