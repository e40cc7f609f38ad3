// Votes on the length of a time step.
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>

namespace moraine {

/// The longest step that somebody allows, why, and which particle asks for it.
struct Vote {
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);

  double time_step = std::numeric_limits<double>::infinity();  // s
  std::string_view reason = "nothing";
  std::size_t particle = nobody;  // index in the store
};

/// The smaller of two votes; a step that is not a number wins, so that guards see it.
inline Vote stricter(Vote const& a, Vote const& b) { return !(b.time_step >= a.time_step) ? b : a; }

}  // namespace moraine
