// Pictures of the liquid in a rigid tank.
#pragma once

#include <filesystem>
#include <vector>

#include "sloshing/tank_response.hpp"

namespace moraine {

/// Acceleration of the ground, surface at the +x wall and force on the tank over time, one line per
/// record. The ending must be .svg or .png, else std::invalid_argument.
void draw_tank_responses(std::filesystem::path const& out,
                         std::vector<TankResponse> const& responses);

}  // namespace moraine
