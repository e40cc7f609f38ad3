// Votes on the length of a time step.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

namespace moraine {

// Reasons of votes that outlive a step, and so a checkpoint.
inline constexpr std::string_view acceleration_limit = "acceleration";
inline constexpr std::string_view motion_limit = "motion";

// Share of the smoothing length that a voted step may carry a particle or a wall.
inline constexpr double longest_motion = 0.5;

/// The longest step that somebody allows, why, and which particle asks for it.
struct Vote {
  static constexpr std::uint64_t nobody = std::numeric_limits<std::uint64_t>::max();

  double time_step = std::numeric_limits<double>::infinity();  // s
  std::string_view reason = "nothing";
  std::uint64_t particle = nobody;  // global id
};

/// The smaller of two votes; a step that is not a number wins, so that guards see it.
inline Vote stricter(Vote const& a, Vote const& b) {
  return std::isnan(a.time_step) || b.time_step >= a.time_step ? a : b;
}

}  // namespace moraine
