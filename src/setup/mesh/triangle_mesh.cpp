#include "setup/mesh/triangle_mesh.hpp"

#include <algorithm>

namespace moraine {

TriangleMesh weld(std::vector<Triangle> const& triangles) {
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * triangles.size());
  for (Triangle const& triangle : triangles)
    mesh.vertices.insert(mesh.vertices.end(), triangle.begin(), triangle.end());
  std::sort(mesh.vertices.begin(), mesh.vertices.end());
  mesh.vertices.erase(std::unique(mesh.vertices.begin(), mesh.vertices.end()), mesh.vertices.end());
  auto const index_of = [&](Vec3 const& corner) {
    auto const found = std::lower_bound(mesh.vertices.begin(), mesh.vertices.end(), corner);
    return static_cast<std::uint32_t>(found - mesh.vertices.begin());
  };
  for (Triangle const& triangle : triangles) {
    std::array const t{index_of(triangle[0]), index_of(triangle[1]), index_of(triangle[2])};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
      ++mesh.degenerate;
    else
      mesh.triangles.push_back(t);
  }
  return mesh;
}

Vec3 area_vector(Triangle const& triangle) {
  return scale(0.5, cross(subtract(triangle[1], triangle[0]), subtract(triangle[2], triangle[0])));
}

}  // namespace moraine
