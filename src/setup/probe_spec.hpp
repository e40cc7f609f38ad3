// What the kinds of gauges beyond points and fronts measure, as plain data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "probes/reduction.hpp"

namespace moraine {

/// A box of places; the whole domain where none is given.
struct WithinSpec {
  bool given = false;
  Vec3 min{}, max{};  // m
};

/// A crater in ground whose surface was flat, at `level` upwards.
struct CraterSpec {
  double level = 0.0;            // m
  Vec3 center{};                 // m, a place on the axis
  std::optional<double> radius;  // m, how far ground is looked at; none: to the end of the domain
  int sectors = 16;              // of the azimuth, in 3D
};

/// What slid and came to rest: how far and how high. Along a side, or round about an origin.
struct DepositSpec {
  double base = 0.0;           // m, upwards
  std::optional<int> along;    // 2 axis + (0 minus | 1 plus)
  std::optional<Vec3> origin;  // m
};

/// A formula of the fields of a particle, and what becomes of its values.
struct ExpressionSpec {
  std::string formula;
  Reduction reduce = Reduction::max;
  MeanWeight weight = MeanWeight::mass;
  std::string unit;  // for tables
};

/// A grid of places: a flat one in 3D.
struct PlaneSpec {
  Vec3 min{}, max{};  // m
  double step = 0.0;  // m
};

/// The members that belong to the gauge's kind count.
struct ProbeSpec {
  // wall: force, torque and pressure of the fluid on a wall, or on its places inside a box.
  std::string wall;
  bool has_part = false;
  Vec3 part_min{}, part_max{};  // m
  Vec3 about{};                 // m, the point of torques
  // line: the state at points at equal distances, ends included.
  Vec3 line_from{}, line_to{};  // m
  int line_points = 11;
  // level: the last place along the line at which there is fluid.
  Vec3 level_from{}, level_to{};  // m
  // line: where distances are counted from when the decay of peaks is asked for.
  std::optional<Vec3> line_origin;  // m
  // sums: energies, momentum and mass of a material.
  std::string of;
  // side: what left through a side of the domain: 2 axis + (0 minus | 1 plus).
  int side = 1;
  // crater, deposit, bubble, rise, expression: the materials that count; none: all.
  std::vector<std::string> materials;
  std::optional<int> up;  // side of the domain that lies above; none: against gravity
  WithinSpec within;
  CraterSpec crater;
  DepositSpec deposit;
  ExpressionSpec expression;
  PlaneSpec plane;
};

}  // namespace moraine
