// A charge in a box of water between walls of any method.
#pragma once

#include <cmath>

#include "setup/case.hpp"
#include "setup/mirror_walls.hpp"

namespace moraine::charge {

inline constexpr double spacing = 0.01;  // m

/// A closed box full of water with a charge of TNT off its middle, between walls of one method.
inline Case charge_in_box(int dimension, int side, WallMethod method, Slip slip) {
  Case c;
  c.dimension = dimension;
  c.numerics.spacing = spacing;
  c.numerics.precision = Precision::full;
  double const size = side * spacing;
  Box box{};
  Point center{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    box.max[axis] = size;
    c.domain.min[axis] = -size;
    c.domain.max[axis] = 2.0 * size;
    center[axis] = 0.3 * size;
  }
  c.time.end = 1.0;
  c.time.fixed_step = 5e-7;
  c.materials = {{"water", WaterPolynomial{}}, {"tnt", Jwl{}}};
  c.regions = {{"sea", "water", box, {}}, {"charge", "tnt", Disc{center, 0.2 * size}, {}}};
  WallSpec wall;
  wall.name = "box";
  wall.box = box;
  wall.slip = slip;
  wall.method = method;
  if (wall.pushes()) wall.repulsion = 1480.0 * 1480.0;
  c.walls = {wall};
  GaugeSpec gauge;
  gauge.name = "load";
  gauge.kind = GaugeKind::wall;
  gauge.probe.wall = "box";
  c.gauges = {gauge};
  end_domain_at_mirrors(c);
  return c;
}

}  // namespace moraine::charge
