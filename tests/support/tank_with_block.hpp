// Still water around a block in an open tank, as a case file without the end of its time.
#pragma once

#include <string>

namespace moraine {

/// 2D, water 0.6 m deep; a block of 0.2 m by 0.2 m hangs in it. `more` follows: further tables.
inline std::string tank_with_block(std::string const& end, std::string const& more = {}) {
  return "time.end = " + end + R"(
space.dimension = 2
physics.gravity = [0.0, -9.81]
resolution = { spacing = 0.02, smoothing_factor = 1.5 }
numerics = { viscosity_alpha = 0.1, viscosity_beta = 0.0, density_diffusion = 0.1 }
material.water = { eos = "tait", reference_sound_speed = 34.3 }
[[region]]
name = "left"
material = "water"
hydrostatic_level = 0.6
box = { min = [0.0, 0.0], max = [0.4, 0.6] }
[[region]]
name = "right"
material = "water"
hydrostatic_level = 0.6
box = { min = [0.6, 0.0], max = [1.0, 0.6] }
[[region]]
name = "above"
material = "water"
hydrostatic_level = 0.6
box = { min = [0.4, 0.36], max = [0.6, 0.6] }
[[region]]
name = "below"
material = "water"
hydrostatic_level = 0.6
box = { min = [0.4, 0.0], max = [0.6, 0.16] }
[[wall]]
name = "tank"
container = { min = [0.0, 0.0], max = [1.0, 0.8] }
open = ["y+"]
[[wall]]
name = "block"
solid = { min = [0.4, 0.16], max = [0.6, 0.36] }
)" + more;
}

}  // namespace moraine
