// Prescribed motions as files.
#pragma once

#include <filesystem>
#include <stdexcept>

#include "motion/rigid_motion.hpp"

namespace moraine {

/// Something is wrong with a motion file; the message names the line where there is one.
struct MotionFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A motion of the first `dimension` axes and the last time of its file [s].
struct FiledMotion {
  RigidMotion motion;
  double end = 0.0;
};

/// Reads a CSV file: a line of column names, `time` and at least one of x, y, z, angle in any
/// order, then one line per time with numbers in s, m and rad. Empty lines and lines that start
/// with # do not count. The values are joined by natural cubic splines (TimeCourse::table).
/// Throws MotionFileError.
FiledMotion read_motion_file(std::filesystem::path const& path, int dimension);

}  // namespace moraine
