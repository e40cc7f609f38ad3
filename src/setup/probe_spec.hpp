// What the kinds of gauges beyond points and fronts measure, as plain data.
#pragma once

#include <string>

#include "base/vec3.hpp"

namespace moraine {

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
  // sums: energies, momentum and mass of a material.
  std::string of;
  // side: what left through a side of the domain: 2 axis + (0 minus | 1 plus).
  int side = 1;
};

}  // namespace moraine
