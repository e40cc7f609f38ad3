// Who has limited the time steps of a run, and how often.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/archive.hpp"
#include "step/time_step.hpp"

namespace moraine {

/// What one reason has had to say.
struct VoteShare {
  std::string_view reason;
  std::uint64_t steps = 0;       // that it limited
  double least_time_step = 0.0;  // s, the shortest of these
};

/// Counts the votes that were followed. Its state travels with a checkpoint.
class VoteTally {
 public:
  /// Call after each step, with the vote that decided it.
  void note(Vote const& vote);

  /// Of the reasons that limited any step, the most frequent first.
  std::vector<VoteShare> shares() const;

  void exchange(Archive& archive);

 private:
  static constexpr std::size_t kinds = vote_reasons.size() + 1;  // the last: any other reason
  std::array<std::uint64_t, kinds> steps_{};
  std::array<double, kinds> least_{};
};

}  // namespace moraine
