#include "report/outlines.hpp"

#include <array>
#include <cmath>

#include "report/settings.hpp"
#include "setup/upward.hpp"

namespace moraine::report {
namespace {

/// Where a gauge looks: "dot" with a place, "line" with both ends, "box" with both corners; an
/// empty shape where it looks at no place of its own.
struct Place {
  char const* shape = "";
  std::vector<Vec3> points;
};

Json point_json(Vec3 const& place) { return {place[0], place[1], place[2]}; }

/// The same place at this height.
Vec3 at_height(Case const& c, ProbeSpec const& probe, Vec3 place, double height) {
  if (auto const side = side_above(c, probe.up))
    place.at(static_cast<std::size_t>(*side / 2)) = *side % 2 == 1 ? height : -height;
  return place;
}

/// The ground that is looked at: flat, about the axis of the crater.
Place crater_place(Case const& c, ProbeSpec const& probe) {
  CraterSpec const& crater = probe.crater;
  Vec3 const center = at_height(c, probe, crater.center, crater.level);
  if (!crater.radius || !side_above(c, probe.up)) return {"dot", {center}};
  Vec3 min = center, max = center;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    min.at(axis) -= *crater.radius;
    max.at(axis) += *crater.radius;
  }
  return {"box", {at_height(c, probe, min, crater.level), at_height(c, probe, max, crater.level)}};
}

Place within_place(WithinSpec const& within) {
  if (!within.given) return {};
  return {"box", {within.min, within.max}};
}

Place place_of(Case const& c, GaugeSpec const& gauge) {
  ProbeSpec const& probe = gauge.probe;
  switch (gauge.kind) {
    case GaugeKind::point:
    case GaugeKind::particle:
      return {"dot", {gauge.position}};
    case GaugeKind::line:
      return {"line", {probe.line_from, probe.line_to}};
    case GaugeKind::level:
      return {"line", {probe.level_from, probe.level_to}};
    case GaugeKind::wall:
      if (!probe.has_part) return {};
      return {"box", {probe.part_min, probe.part_max}};
    case GaugeKind::crater:
      return crater_place(c, probe);
    case GaugeKind::deposit:
      return {"dot",
              {at_height(c, probe, probe.deposit.origin.value_or(Vec3{}), probe.deposit.base)}};
    case GaugeKind::bubble:
    case GaugeKind::rise:
    case GaugeKind::expression:
      return within_place(probe.within);
    case GaugeKind::plane:
      return {"box", {probe.plane.min, probe.plane.max}};
    case GaugeKind::front:
    case GaugeKind::sums:
    case GaugeKind::side:
    case GaugeKind::budget:
      return {};
  }
  return {};
}

/// "x-", "z+", as in the case file.
Json open_sides(WallSpec const& wall) {
  auto sides = Json::array();
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end)
      if (wall.open.at(axis).at(end))
        sides.push_back(std::string(1, "xyz"[axis]) + (end == 0 ? '-' : '+'));
  return sides;
}

}  // namespace

Json wall_boxes_of(Case const& c) {
  auto boxes = Json::array();
  for (WallSpec const& wall : c.walls)
    if (!wall.motion.given())
      boxes.push_back({{"name", wall.name},
                       {"min", point_json(wall.box.min)},
                       {"max", point_json(wall.box.max)},
                       {"open", open_sides(wall)}});
  return boxes;
}

Json probes_of(Case const& c) {
  auto probes = Json::array();
  for (GaugeSpec const& gauge : c.gauges) {
    Place const place = place_of(c, gauge);
    if (place.points.empty()) continue;
    auto points = Json::array();
    for (Vec3 const& point : place.points) points.push_back(point_json(point));
    probes.push_back({{"name", gauge.name},
                      {"kind", kind_name(gauge)},
                      {"shape", place.shape},
                      {"points", std::move(points)}});
  }
  return probes;
}

}  // namespace moraine::report
