// Votes on the length of a time step.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

namespace moraine {

// Reasons of votes.
inline constexpr std::string_view sound_limit = "sound and viscosity";
inline constexpr std::string_view acceleration_limit = "acceleration";
inline constexpr std::string_view motion_limit = "motion";
inline constexpr std::string_view wall_motion_limit = "motion of a wall";
inline constexpr std::string_view wall_acceleration_limit = "acceleration of a wall";
inline constexpr std::string_view repulsion_limit = "repulsion of a wall";
inline constexpr std::string_view burn_limit = "programmed burn";
inline constexpr std::string_view expansion_limit = "expansion";
inline constexpr std::string_view damping_limit = "damping";
inline constexpr std::string_view viscous_limit = "physical viscosity";
inline constexpr std::string_view penalty_limit = "penalty between materials";
inline constexpr std::string_view fixed_limit = "fixed step";
inline constexpr std::string_view largest_limit = "largest step";
inline constexpr std::string_view end_of_run = "end of run";

/// All of them, in no order of rank.
inline constexpr std::array vote_reasons{
    sound_limit,     acceleration_limit, motion_limit,  wall_motion_limit, wall_acceleration_limit,
    repulsion_limit, burn_limit,         damping_limit, viscous_limit,     penalty_limit,
    expansion_limit, fixed_limit,        largest_limit, end_of_run};

/// The reason with these words, as text that lives as long as the program: votes that come from a
/// checkpoint. "nothing" for words that are no reason.
inline std::string_view kept_reason(std::string_view words) {
  for (std::string_view const reason : vote_reasons)
    if (words == reason) return reason;
  return "nothing";
}

// Share of the smoothing length that a voted step may carry a particle or a wall.
inline constexpr double longest_motion = 0.5;

// Share of its density that a particle may lose in a step: gas that bursts into a void would come
// out with less than none.
inline constexpr double largest_expansion_of_step = 0.5;

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
