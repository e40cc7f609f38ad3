// A prescribed motion as the case file says it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "motion/rigid_motion.hpp"

namespace moraine {

/// Translation and rotation by formulas, or both by a file; nothing of it: no motion.
struct MotionSpec {
  std::vector<std::string> translation;  // formulas of t [s] in m, one for each axis
  std::string rotation;                  // formula of t [s] in rad
  std::array<double, 3> about{};         // m
  std::array<double, 3> axis{0, 0, 1};   // of any length but zero; always z in 2D
  std::string file;                      // of the case: relative to it; after reading: absolute
  std::optional<RigidMotion> motion{};   // what these say; set where the case is checked

  bool given() const { return !translation.empty() || !rotation.empty() || !file.empty(); }
};

}  // namespace moraine
