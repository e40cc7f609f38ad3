// Bodies from STL files.
#pragma once

#include <cmath>
#include <memory>
#include <string>

#include "setup/mesh/mesh_report.hpp"
#include "setup/mesh/winding_number.hpp"
#include "setup/shape/box.hpp"

namespace moraine {

/// What happens with triangles that do not close a body.
enum class StlDefects : std::uint8_t { refuse, accept };

/// A mesh with what is known of it.
struct MeshBody {
  MeshReport report;
  WindingNumber winding;
};

/// The inside of the triangles of a file, 3D only.
struct StlBody {
  std::string file;   // of the case: relative to the case file; after reading: absolute
  std::string units;  // length unit of the numbers in the file, which does not say it
  Point shift{};      // m, added to all coordinates
  StlDefects defects = StlDefects::refuse;
  std::shared_ptr<MeshBody const> body;
};

/// Inside: a winding number beyond one half, of either sign, so that a body turned inside out is
/// the same body, and where bodies of one file overlap is inside. Half-open as a box: points on a
/// face belong to it where the inside lies towards larger coordinates. Points closer to a face than
/// `tolerance` [m] count as on it.
inline bool contains(StlBody const& stl, Point const& point, int, double tolerance) {
  // Moved off any face that it may lie on, never along an axis or a diagonal.
  Point const q = add(point, {tolerance, 0.7 * tolerance, 0.4 * tolerance});
  MeshReport const& report = stl.body->report;
  if (!contains(Box{report.min, report.max}, q, 3, 0.0)) return false;
  return std::abs(stl.body->winding(q)) > 0.5;
}

/// The smallest box around the triangles.
inline Box bounds(StlBody const& stl, int) { return {stl.body->report.min, stl.body->report.max}; }

}  // namespace moraine
