// A stage of a run as the case file says it.
#pragma once

#include <optional>
#include <string>

namespace moraine {

/// When a stage ends: as soon as one of the given conditions holds.
struct UntilSpec {
  std::optional<double> after;            // s since the stage began
  std::optional<double> rms_speed_below;  // m/s
  std::optional<double> steady_for;       // s
  std::string gauge;                      // name of a point gauge; empty: none
  std::optional<double> pressure_above;   // Pa, of the gauge
  std::optional<double> pressure_below;   // Pa
};

/// What a stage changes when it begins, and what is different while it lasts.
struct StageSpec {
  std::string name;
  std::optional<double> damping_time;  // s: velocities fall by e in this time
  std::string remove_wall;             // name of a wall; empty: none
  std::string detonate;                // name of a region; empty: none
  std::string into;                    // name of the material that it becomes
  UntilSpec until;
};

}  // namespace moraine
