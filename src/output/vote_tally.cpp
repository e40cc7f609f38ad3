#include "output/vote_tally.hpp"

#include <algorithm>
#include <stdexcept>

namespace moraine {

void VoteTally::note(Vote const& vote) {
  auto const found = std::find(vote_reasons.begin(), vote_reasons.end(), vote.reason);
  auto const kind = static_cast<std::size_t>(found - vote_reasons.begin());
  least_[kind] = steps_[kind] == 0 ? vote.time_step : std::min(least_[kind], vote.time_step);
  ++steps_[kind];
}

std::vector<VoteShare> VoteTally::shares() const {
  std::vector<VoteShare> shares;
  for (std::size_t kind = 0; kind < kinds; ++kind)
    if (steps_[kind] > 0)
      shares.push_back({kind < vote_reasons.size() ? vote_reasons[kind] : "nothing", steps_[kind],
                        least_[kind]});
  std::stable_sort(shares.begin(), shares.end(),
                   [](VoteShare const& a, VoteShare const& b) { return a.steps > b.steps; });
  return shares;
}

void VoteTally::exchange(Archive& archive) {
  std::vector<std::uint64_t> steps(steps_.begin(), steps_.end());
  std::vector<double> least(least_.begin(), least_.end());
  archive.array("votes/steps", "", steps);
  archive.array("votes/least_time_step", "s", least);
  if (steps.size() != kinds || least.size() != kinds)
    throw std::runtime_error("the saved votes are not those of this program");
  std::copy(steps.begin(), steps.end(), steps_.begin());
  std::copy(least.begin(), least.end(), least_.begin());
}

}  // namespace moraine
