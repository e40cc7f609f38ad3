// Triangles that share vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/vec3.hpp"

namespace moraine {

/// One triangle by its corners [m], counterclockwise seen from outside of the body.
using Triangle = std::array<Vec3, 3>;

/// Triangles as indices of vertices.
struct TriangleMesh {
  std::vector<Vec3> vertices;  // m
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t degenerate = 0;  // triangles left out: two corners in one place

  Triangle corners(std::size_t i) const {
    auto const& t = triangles[i];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
};

/// Joins corners in the same place, to the bit, into one vertex; vertices are in ascending order of
/// x, y, z. At most 2^32 / 3 triangles.
TriangleMesh weld(std::vector<Triangle> const& triangles);

/// Normal of a triangle out of the body, as long as its area [m^2].
Vec3 area_vector(Triangle const& triangle);

}  // namespace moraine
