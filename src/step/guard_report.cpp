#include "step/guard_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <utility>

namespace moraine {
namespace {

constexpr std::size_t told = 5;  // particles of a finding that are told one by one

std::string who_of(GuardMoment const& at, std::size_t particle) {
  ParticleStore const& store = at.model.particles;
  std::string place;
  for (int axis = 0; axis < store.dimension(); ++axis)
    place += fmt::format("{}{:.6g}", axis == 0 ? "" : ", ",
                         store.component(Field::position, axis)[particle]);
  return fmt::format("particle {} ({}) at ({}) m", store.id()[particle],
                     at.model.materials[store.material()[particle]].name, place);
}

std::string limit_of(Vote const& vote) {
  std::string text(vote.reason);
  if (vote.particle != Vote::nobody) text += fmt::format(" of particle {}", vote.particle);
  return text;
}

std::string text_of(GuardMoment const& at, Finding const& finding) {
  auto const& suspects = finding.suspects;
  if (suspects.empty())
    return fmt::format("{}; time {:.6g} s, step {}", finding.cause(Finding::no_particle), at.time,
                       at.step);
  std::size_t const worst = suspects.front().particle;
  std::string text =
      fmt::format("unstable: {}: {}; time {:.6g} s, step {}, time step {:.3g} s limited by {}",
                  who_of(at, worst), finding.cause(worst), at.time, at.step, at.vote.time_step,
                  limit_of(at.vote));
  for (std::size_t k = 1; k < std::min(told, suspects.size()); ++k)
    text += fmt::format("\n  also {}: {}", who_of(at, suspects[k].particle),
                        finding.cause(suspects[k].particle));
  if (suspects.size() > told) text += fmt::format("\n  and {} more", suspects.size() - told);
  return text + fmt::format("\n  guard: {}", info(finding.guard).name);
}

}  // namespace

void VoteHistory::note(Vote const& vote) { votes_[noted_++ % length] = vote; }

std::string VoteHistory::text() const {
  std::string text;
  for (std::uint64_t k = noted_ < length ? 0 : noted_ - length; k < noted_; ++k) {
    Vote const& vote = votes_[k % length];
    text +=
        fmt::format("{}{:.4g} s ({})", text.empty() ? "" : ", ", vote.time_step, limit_of(vote));
  }
  return text;
}

void VoteHistory::exchange(Archive& archive) {
  std::vector<double> steps;
  std::vector<std::uint64_t> particles;
  std::string reasons;
  for (Vote const& vote : votes_) {
    steps.push_back(vote.time_step);
    particles.push_back(vote.particle);
    reasons += std::string(vote.reason) + '\n';
  }
  archive.number("guards/votes_noted", noted_);
  archive.array("guards/vote_steps", "s", steps);
  archive.array("guards/vote_particles", "", particles);
  archive.text("guards/vote_reasons", reasons);
  if (!archive.restoring()) return;
  std::istringstream lines(reasons);
  for (std::size_t k = 0; k < length && k < steps.size() && k < particles.size(); ++k) {
    std::string reason;
    std::getline(lines, reason);
    votes_[k] = {steps[k], kept_reason(reason), particles[k]};
  }
}

SimulationError error_of(GuardMoment const& at, std::vector<Finding> findings) {
  std::string text;
  std::map<std::uint64_t, int> flags;
  bool named = false;
  for (Finding& finding : findings) {
    std::stable_sort(finding.suspects.begin(), finding.suspects.end(),
                     [](Suspect const& a, Suspect const& b) { return a.badness > b.badness; });
    text += (text.empty() ? "" : "\n") + text_of(at, finding);
    named = named || !finding.suspects.empty();
    for (Suspect const& suspect : finding.suspects)
      flags.try_emplace(at.model.particles.id()[suspect.particle], flag_of(finding.guard));
  }
  std::string const votes = at.votes.text();
  if (named && !votes.empty()) text += "\n  last time steps: " + votes;
  std::vector<Flag> list;
  for (auto const& [particle, guard] : flags) list.push_back({particle, guard});
  return SimulationError(text, std::move(list));
}

}  // namespace moraine
