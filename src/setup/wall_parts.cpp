#include "setup/wall_parts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "setup/mirror_walls.hpp"
#include "smoothing/kernel_names.hpp"
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
  // A symmetry plane or the mirror of another wall cuts the box: what is beyond is an image.
  auto const mirrors = mirror_sides(c);
  auto const cuts = [&](std::size_t axis, std::size_t end) {
    auto const& mirror = mirrors[axis][end];
    return c.symmetry.planes[axis][end] || (mirror && c.walls[*mirror].name != spec.name);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cuts(axis, 0) && wall.min[axis] <= c.domain.min[axis]) {
      wall.min[axis] = c.domain.min[axis];
      wall.open[axis][0] = true;
    }
    if (cuts(axis, 1) && wall.max[axis] >= c.domain.max[axis]) {
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

/// Spots in the middles of even squares over a face, those in the box of the part.
FacePart part_of(Case const& c, WallFace const& face, std::size_t index, ProbeSpec const& probe) {
  double const slack = 1e-9 * c.numerics.spacing;
  FacePart part{index, face.low, face.high, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    part.low[k] = (probe.has_part ? probe.part_min[k] : face.low[k]) - slack;
    part.high[k] = (probe.has_part ? probe.part_max[k] : face.high[k]) + slack;
  }
  std::array<int, 3> count{1, 1, 1};
  FaceSpot spot{{}, 1.0};
  for (std::size_t k = 0; k < static_cast<std::size_t>(c.dimension); ++k) {
    if (k == face.axis) continue;
    double const length = face.high[k] - face.low[k];
    count[k] = std::max(1, static_cast<int>(std::lround(length / c.numerics.spacing)));
    spot.area *= length / count[k];
  }
  for (int z = 0; z < count[2]; ++z)
    for (int y = 0; y < count[1]; ++y)
      for (int x = 0; x < count[0]; ++x) {
        std::array<int, 3> const at{x, y, z};
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
          spot.place[k] = face.low[k] + (at[k] + 0.5) / count[k] * (face.high[k] - face.low[k]);
          bool const counts = k < static_cast<std::size_t>(c.dimension);
          inside = inside &&
                   (!counts || (spot.place[k] >= part.low[k] && spot.place[k] <= part.high[k]));
        }
        if (inside) part.spots.push_back(spot);
      }
  return part;
}

}  // namespace

std::vector<WallFace> faces_of_wall(Case const& c, std::size_t wall) {
  WallSpec const& spec = c.walls[wall];
  if (spec.method == WallMethod::dummy) return {};
  BoxWall const box = box_wall(c, spec);
  FaceRepulsion repulsion;
  if (spec.pushes())
    repulsion = {spec.repulsion.value_or(0.0),
                 spec.repulsion_range.value_or(0.5 * c.numerics.spacing)};
  // Where an image goes on with what is cut, and at periodic seams.
  std::array<std::array<bool, 2>, 3> goes_on{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end) {
      double const side =
          end == 0 ? c.domain.min[axis] - box.min[axis] : box.max[axis] - c.domain.max[axis];
      bool const cut = is_plane(c, axis, end) && box.open[axis][end] && side >= 0.0;
      goes_on[axis][end] = cut || spans_period(box, axis);
    }
  auto faces = make_wall_faces(box, c.numerics.spacing, repulsion, goes_on);
  auto const mirrors = mirror_sides(c);
  for (WallFace& face : faces) {
    face.wall = static_cast<std::uint32_t>(wall);
    face.mirror = mirrors[face.axis][face.end] == wall;
  }
  return faces;
}

std::vector<Dummy> make_wall_dummies(Case const& c, WallSpec const& wall, std::uint32_t surface) {
  if (wall.method != WallMethod::dummy) return {};
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

std::vector<FacePart> face_parts(Case const& c, GaugeSpec const& gauge) {
  std::vector<FacePart> parts;
  std::size_t index = 0;
  for (std::size_t w = 0; w < c.walls.size(); ++w)
    for (WallFace const& face : faces_of_wall(c, w)) {
      if (c.walls[w].name == gauge.probe.wall)
        parts.push_back(part_of(c, face, index, gauge.probe));
      ++index;
    }
  return parts;
}

void check_wall_parts(Case const& c) {
  std::vector<InputProblem> problems;
  for (GaugeSpec const& gauge : c.gauges) {
    if (gauge.kind != GaugeKind::wall || !gauge.probe.has_part) continue;
    auto const members = wall_members(c, gauge);
    auto const faces = face_parts(c, gauge);
    bool const any = std::any_of(faces.begin(), faces.end(),
                                 [](FacePart const& face) { return !face.spots.empty(); });
    if (!any && std::find(members.begin(), members.end(), 1) == members.end())
      problems.push_back(problem_of(c, "gauge." + gauge.name + ".part.min",
                                    fmt::format("makes a box without any place of the faces of "
                                                "wall \"{}\"",
                                                gauge.probe.wall)));
  }
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

}  // namespace moraine
