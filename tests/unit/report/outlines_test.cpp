#include "report/outlines.hpp"

#include <gtest/gtest.h>

namespace moraine::report {
namespace {

GaugeSpec gauge(char const* name, GaugeKind kind) {
  GaugeSpec made;
  made.name = name;
  made.kind = kind;
  return made;
}

Json only_probe(Case const& c) {
  Json const probes = probes_of(c);
  EXPECT_EQ(probes.size(), 1u) << probes;
  return probes.empty() ? Json::object() : probes.at(0);
}

TEST(ReportOutlines, AreOfWallsAtRestWithTheirOpenSides) {
  Case c;
  c.dimension = 2;
  WallSpec tank;
  tank.name = "tank";
  tank.box = {{0.0, -1.0, 0.0}, {2.0, 1.0, 0.0}};
  tank.method = WallMethod::mirror;
  tank.open.at(1).at(1) = true;
  WallSpec paddle = tank;
  paddle.motion.rotation = "t";
  c.walls = {tank, paddle};
  EXPECT_EQ(wall_boxes_of(c), Json::parse(R"([{"name": "tank", "min": [0.0, -1.0, 0.0],
    "max": [2.0, 1.0, 0.0], "open": ["y+"]}])"));
}

TEST(ReportOutlines, ShowWhereEachKindOfGaugeLooks) {
  Case c;
  c.dimension = 3;
  c.gravity = {0.0, 0.0, -9.81};
  auto const box = [](GaugeKind kind) {
    GaugeSpec made = gauge("box", kind);
    made.probe.has_part = made.probe.within.given = true;
    for (auto* const corner : {&made.probe.part_max, &made.probe.within.max, &made.probe.plane.max})
      *corner = {1.0, 2.0, 3.0};
    return made;
  };
  for (auto const kind : {GaugeKind::wall, GaugeKind::bubble, GaugeKind::rise,
                          GaugeKind::expression, GaugeKind::plane}) {
    c.gauges = {box(kind)};
    Json const probe = only_probe(c);
    EXPECT_EQ(probe.at("shape"), "box");
    EXPECT_EQ(probe.at("points"), Json::parse("[[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]"));
  }
  for (auto const kind : {GaugeKind::line, GaugeKind::level}) {
    c.gauges = {gauge("line", kind)};
    EXPECT_EQ(only_probe(c).at("shape"), "line");
    EXPECT_EQ(only_probe(c).at("points").size(), 2u);
  }
}

TEST(ReportOutlines, PutHeightsAboveTheGround) {
  Case c;
  c.dimension = 3;
  GaugeSpec crater = gauge("crater", GaugeKind::crater);
  crater.probe.crater = {0.5, {1.0, 2.0, 77.0}, 3.0};
  c.gauges = {crater};
  EXPECT_EQ(only_probe(c).at("points"), Json::parse("[[-2.0, -1.0, 0.5], [4.0, 5.0, 0.5]]"));
  // Down is up: heights are counted against the axis.
  c.gauges.front().probe.up = 4;
  EXPECT_EQ(only_probe(c).at("points").at(0).at(2), -0.5);
  c.gauges.front().probe.crater.radius.reset();
  EXPECT_EQ(only_probe(c).at("shape"), "dot");
  c.gauges = {gauge("deposit", GaugeKind::deposit)};
  c.gauges.front().probe.deposit.base = 0.25;
  EXPECT_EQ(only_probe(c).at("points"), Json::parse("[[0.0, 0.0, 0.25]]"));
}

TEST(ReportOutlines, LeaveOutGaugesWithoutAPlace) {
  Case c;
  for (auto const kind : {GaugeKind::front, GaugeKind::wall, GaugeKind::sums, GaugeKind::side,
                          GaugeKind::budget, GaugeKind::bubble, GaugeKind::expression})
    c.gauges.push_back(gauge("nowhere", kind));
  EXPECT_EQ(probes_of(c), Json::array());
}

}  // namespace
}  // namespace moraine::report
