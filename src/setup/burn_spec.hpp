// How an explosive burns, as the case file says it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace moraine {

/// `instantaneous`: products from the start; `programmed`: behind a front of given speed.
enum class BurnKind : std::uint8_t { instantaneous, programmed };

/// Programmed burn (matter/burn/programmed_burn.hpp); all of it means nothing with instantaneous.
struct BurnSpec {
  BurnKind kind = BurnKind::instantaneous;
  // Absent until the case has been checked: then those of the material or of its C-J state.
  std::optional<double> detonation_velocity{};  // m/s
  std::optional<double> cj_volume{};
  double width_in_spacings = 1.5;
  double delay = 0.0;                                           // s
  std::vector<std::array<double, 3>> ignition_points{};         // m
  std::optional<std::array<double, 3>> line_from{}, line_to{};  // m
  std::optional<std::array<double, 3>> plane_point{};           // m
  std::optional<std::array<double, 3>> plane_normal{};
};

}  // namespace moraine
