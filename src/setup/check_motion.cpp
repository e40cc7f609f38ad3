#include "setup/check_motion.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "setup/geometry.hpp"
#include "setup/motion_file.hpp"

namespace moraine {
namespace {

// Parts of the run at whose ends motions are looked at.
constexpr int instants = 1000;

/// A twentieth of the time in which sound passes a smoothing length [s], shorter than a time step.
double difference_step(Case const& c) {
  double fastest = 0.0;
  for (MaterialSpec const& material : c.materials)
    fastest =
        std::max(fastest, std::visit(
                              [](auto const& law) {
                                return law.sound_speed(law.reference_density, law.reference_energy);
                              },
                              material.eos));
  double const time = 0.05 * c.numerics.smoothing_length() / fastest;
  return std::isfinite(time) && time > 0.0 ? time : 1e-6 * c.time.end;
}

class MotionCheck {
 public:
  MotionCheck(WallSpec& wall, std::string const& key, Case const& c, Source& source)
      : spec_(wall.motion), end_(end_of_wall(c, wall)), key_(key), case_(c), source_(source) {}

  void run() {
    if (!spec_.given()) {
      for (auto const* name : {"about", "axis"})
        if (source_.has(key_ + name))
          source_.report_value(key_ + name, "says how to turn, but nothing turns",
                               "give motion.rotation or motion.file");
      return;
    }
    RigidMotion motion;
    bool const sound = spec_.file.empty() ? read_formulas(motion) : read_file(motion);
    if (!turn_axis(motion) || !sound) return;
    spec_.motion = motion;
  }

 private:
  bool wrong(std::string const& name, std::string rule, std::string hint = {}) {
    source_.report_value(key_ + name, std::move(rule), std::move(hint));
    return false;
  }

  bool read_file(RigidMotion& motion) {
    if (!spec_.translation.empty() || !spec_.rotation.empty())
      return wrong("file", "is given together with formulas", "leave out one of the two");
    std::filesystem::path path = spec_.file;
    if (path.is_relative()) path = std::filesystem::path(case_.file).parent_path() / path;
    std::error_code ignored;
    spec_.file = std::filesystem::absolute(path, ignored).lexically_normal().string();
    try {
      FiledMotion const filed = read_motion_file(path, case_.dimension);
      motion = filed.motion;
      if (filed.end < end_)
        return wrong("file", fmt::format("ends at {:.6g} s, before the {} at {:.6g} s", filed.end,
                                         end_ < case_.time.end ? "wall" : "run", end_));
      for (std::size_t k = 0; k < 4; ++k) {
        TimeCourse const& course = k < 3 ? motion.translation[k] : motion.rotation;
        if (std::fabs(course.at(0.0).value) > 1e-9 * case_.numerics.spacing)
          return wrong("file", "displaces the wall at t = 0",
                       "the wall starts where its box is: make it 0 there");
      }
    } catch (MotionFileError const& error) {
      return wrong("file", error.what());
    }
    return true;
  }

  bool read_formulas(RigidMotion& motion) {
    bool sound = true;
    auto const count = static_cast<std::size_t>(case_.dimension);
    if (!spec_.translation.empty() && spec_.translation.size() != count)
      return wrong("translation", fmt::format("has {} formulas; {} are expected, one for each axis",
                                              spec_.translation.size(), count));
    for (std::size_t axis = 0; axis < spec_.translation.size(); ++axis)
      sound = formula(spec_.translation[axis], "translation", motion.translation[axis]) && sound;
    if (!spec_.rotation.empty()) {
      if (case_.dimension == 1) return wrong("rotation", "is not possible in 1D");
      sound = formula(spec_.rotation, "rotation", motion.rotation) && sound;
    }
    return sound;
  }

  bool formula(std::string const& text, std::string const& name, TimeCourse& course) {
    double const step = difference_step(case_);
    try {
      course = TimeCourse::formula(text, step);
    } catch (std::invalid_argument const& error) {
      return wrong(name,
                   fmt::format("holds \"{}\", which is no formula of t: {}", text, error.what()),
                   "formulas have no units: lengths in m, angles in rad, t in s");
    }
    return is_smooth(text, name, course);
  }

  /// What stands still at the start, is a number throughout, and does not jump.
  bool is_smooth(std::string const& text, std::string const& name, TimeCourse const& course) {
    double const interval = end_ / instants;
    CourseState before;
    for (int n = 0; n <= instants; ++n) {
      // Between round times, so that the differences of a rate do not span a jump.
      double const time = (n == 0 || n == instants ? n : n - 0.382) * interval;
      CourseState const state = course.at(time);
      std::string const holds = fmt::format("holds \"{}\", which ", text);
      if (!std::isfinite(state.value + state.rate + state.second_rate))
        return wrong(name, holds + fmt::format("is no finite number at t = {:.6g} s", time));
      if (n == 0 && std::fabs(state.value) > 1e-9 * case_.numerics.spacing)
        return wrong(name, holds + fmt::format("is {:.4g} at t = 0", state.value),
                     "the wall starts where its box is: make it 0 there");
      // A rise that the rates at both ends, and their change between them, cannot explain.
      double const rates = std::fabs(before.rate) + std::fabs(state.rate);
      double const bend = std::fabs(before.second_rate) + std::fabs(state.second_rate);
      double const possible = interval * (rates + interval * bend);
      double const risen = std::fabs(state.value - before.value);
      if (n > 0 && risen > 10.0 * possible + 0.5 * case_.numerics.spacing)
        return wrong(name, holds + fmt::format("jumps by {:.4g} before t = {:.6g} s", risen, time));
      before = state;
    }
    return true;
  }

  bool turn_axis(RigidMotion& motion) {
    motion.about = spec_.about;
    double const size = length(spec_.axis);
    if (source_.has(key_ + "axis") && case_.dimension < 3)
      return wrong("axis", "is possible in 3D only", "leave it out");
    if (!(size > 0.0)) return wrong("axis", "has no length");
    for (std::size_t k = 0; k < 3; ++k) motion.axis[k] = spec_.axis[k] / size;
    return true;
  }

  MotionSpec& spec_;
  double end_;  // s, up to which the motion matters
  std::string const& key_;
  Case const& case_;
  Source& source_;
};

}  // namespace

void check_motion(WallSpec& wall, std::string const& key, Case const& c, Source& source) {
  if (c.dimension == 0) return;
  MotionCheck(wall, key, c, source).run();
}

double end_of_wall(Case const& c, WallSpec const& wall) {
  double begins = 0.0;  // of the stage, at the latest
  for (StageSpec const& stage : c.stages) {
    if (!wall.name.empty() && stage.remove_wall == wall.name) return std::min(begins, c.time.end);
    if (!stage.until.after) break;
    begins += *stage.until.after;
  }
  return c.time.end;
}

Box swept_box(WallSpec const& wall, Case const& c) {
  Box const& box = wall.box;
  if (!wall.motion.motion) return box;
  double const end = end_of_wall(c, wall);
  auto const axes = static_cast<std::size_t>(c.dimension);
  Box swept = box;
  for (int n = 0; n <= instants; ++n) {
    RigidState const state = wall.motion.motion->at(end * n / instants);
    for (std::size_t corner = 0; corner < (std::size_t{1} << axes); ++corner) {
      Point place{};
      for (std::size_t k = 0; k < axes; ++k)
        place[k] = ((corner >> k) & 1) != 0 ? box.max[k] : box.min[k];
      place = state.place(place);
      swept = around(swept, {place, place});
    }
  }
  // Along a periodic axis a wall that does not turn comes in again where it leaves.
  for (std::size_t axis = 0; axis < axes && !wall.motion.motion->rotation.given(); ++axis) {
    if (!c.periodic[axis]) continue;
    swept.min[axis] = box.min[axis];
    swept.max[axis] = box.max[axis];
  }
  return swept;
}

}  // namespace moraine
