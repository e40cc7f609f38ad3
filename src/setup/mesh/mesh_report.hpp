// Whether triangles close a body, and where they do not.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setup/mesh/triangle_mesh.hpp"

namespace moraine {

/// Bad edges that hang together: how many of each kind, and the box around them.
struct MeshDefect {
  std::size_t open = 0;         // edges of one triangle only: the rim of a hole
  std::size_t overlapping = 0;  // edges of more than two triangles
  std::size_t turned = 0;       // edges of two triangles that disagree about outside
  Vec3 min{};                   // m
  Vec3 max{};                   // m
};

/// What is known of a mesh as a body. Every edge of a closed body belongs to two triangles, which
/// run through it in opposite senses.
struct MeshReport {
  std::size_t triangles = 0;
  std::size_t degenerate = 0;  // left out
  std::size_t open_edges = 0;
  std::size_t overlapping_edges = 0;
  std::size_t turned_edges = 0;
  std::vector<MeshDefect> defects;  // in the order of their first vertex
  double volume = 0.0;              // m^3, sum of x_0 . (x_1 x x_2) / 6; exact for a closed body
  Vec3 min{};                       // m
  Vec3 max{};                       // m

  bool watertight() const { return open_edges + overlapping_edges + turned_edges == 0; }
};

MeshReport report_on(TriangleMesh const& mesh);

/// "3 open edges around (0, 0, 1) to (1, 1, 1)", at most `most` places, then how many more.
std::string defects_text(MeshReport const& report, std::size_t most = 3);

}  // namespace moraine
