// The case that the end-to-end tests run, with room for other lines.
#pragma once

#include <string>

namespace moraine {

/// 150 particles of water that start to flow in a closed tank. `time`: inner text of the time
/// table; `spacing` as it stands in the file.
inline std::string small_case(std::string const& time = "end = 0.02, courant = 0.2",
                              std::string const& spacing = "0.02") {
  return R"(title = "small dam"
space.dimension = 2
physics.gravity = [0.0, -9.81]
resolution = { spacing = )" +
         spacing + R"(, smoothing_factor = 1.5 }
time = { )" +
         time + R"( }
output = { frames = 0.005, gauges = 0.002, sums = 0.004, frame_times = [0.0075] }
material.water = { eos = "tait", reference_sound_speed = 20.0 }
[[region]]
name = "column"
material = "water"
box = { min = [0.0, 0.0], max = [0.2, 0.3] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [0.6, 0.4] }
[[gauge]]
name = "foot"
position = [0.02, 0.02]
[[gauge]]
name = "tip"
kind = "front"
material = "water"
)";
}

}  // namespace moraine
