#include "setup/wall_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "smoothing/kernels.hpp"
#include "walls/clearance.hpp"

namespace moraine {
namespace {

BoxWall box_wall(Case const& c, WallSpec const& spec) {
  BoxWall wall;
  wall.dimension = c.dimension;
  wall.min = spec.box.min;
  wall.max = spec.box.max;
  wall.solid = spec.form == WallForm::container ? SolidSide::outside : SolidSide::inside;
  wall.open = spec.open;
  wall.periodic = {c.periodic, c.domain.min, c.domain.max};
  // A symmetry plane cuts the box: its other half is a mirror image.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const& planes = c.symmetry.planes[axis];
    if (planes[0] && wall.min[axis] <= c.domain.min[axis]) {
      wall.min[axis] = c.domain.min[axis];
      wall.open[axis][0] = true;
    }
    if (planes[1] && wall.max[axis] >= c.domain.max[axis]) {
      wall.max[axis] = c.domain.max[axis];
      wall.open[axis][1] = true;
    }
  }
  return wall;
}

int layers_of(Case const& c) {
  return static_cast<int>(std::ceil(
      kernel_support * c.numerics.largest_smoothing_length() / c.numerics.spacing - 1e-9));
}

/// The place of the wall's faces that is nearest to a dummy; of several the one on its own face.
Vec3 nearest_place(Case const& c, WallSpec const& wall, Dummy const& dummy) {
  Vec3 place = dummy.position;
  if (wall.form == WallForm::solid)
    place = make_box_surface(box_wall(c, wall), 0).sample(dummy.face, dummy.uv, 0.0).position;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    place[axis] = std::clamp(place[axis], wall.box.min[axis], wall.box.max[axis]);
  return place;
}

bool is_member(Case const& c, WallSpec const& wall, ProbeSpec const& probe, Dummy const& dummy) {
  if (!probe.has_part) return true;
  Vec3 const place = nearest_place(c, wall, dummy);
  double const slack = 1e-9 * c.numerics.spacing;  // places on the box count
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    if (place[axis] < probe.part_min[axis] - slack || place[axis] > probe.part_max[axis] + slack)
      return false;
  return true;
}

}  // namespace

std::vector<Dummy> make_wall_dummies(Case const& c, WallSpec const& wall, std::uint32_t surface) {
  return make_dummy_layer(box_wall(c, wall), c.numerics.spacing, layers_of(c), surface);
}

double wall_clearance(Case const& c, WallSpec const& wall, Dummy const& dummy) {
  return clearance(box_wall(c, wall), layers_of(c) * c.numerics.spacing, dummy);
}

std::vector<std::uint8_t> wall_members(Case const& c, GaugeSpec const& gauge) {
  std::vector<std::uint8_t> members;
  for (WallSpec const& wall : c.walls)
    for (Dummy const& dummy : make_wall_dummies(c, wall, 0))
      members.push_back(
          wall.name == gauge.probe.wall && is_member(c, wall, gauge.probe, dummy) ? 1 : 0);
  return members;
}

void check_wall_parts(Case const& c) {
  std::vector<InputProblem> problems;
  for (GaugeSpec const& gauge : c.gauges) {
    if (gauge.kind != GaugeKind::wall || !gauge.probe.has_part) continue;
    auto const members = wall_members(c, gauge);
    if (std::find(members.begin(), members.end(), 1) == members.end())
      problems.push_back(problem_of(c, "gauge." + gauge.name + ".part.min",
                                    fmt::format("makes a box without any place of the faces of "
                                                "wall \"{}\"",
                                                gauge.probe.wall)));
  }
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

}  // namespace moraine
