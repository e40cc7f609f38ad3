// Runs members, several at a time, each in a process of its own.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "sweep/member_folder.hpp"
#include "sweep/sweep_progress.hpp"

namespace moraine {

/// Threads are shared out among the members that run at once, at least one for each.
struct RunSettings {
  std::size_t at_once = 1;
  int threads = 1;
};

/// Starts those of `members` whose number is in `wanted`, in that order, or goes on with them from
/// their checkpoints. One that a signal kills is taken up again, up to twice; one whose folder says
/// that it reached its end is done, however its process ended. `ended` gets the number of each
/// member that has ended and what has become of it. On Ctrl-C or SIGTERM, running members are asked
/// to stop, which saves their state; then the result is false. Throws OutputError if a folder
/// cannot be written.
bool run_members(std::vector<MemberFolder> const& members, std::vector<std::size_t> const& wanted,
                 RunSettings const& settings, SweepCount count, SweepProgress& progress,
                 std::function<void(std::size_t, MemberStatus const&)> const& ended);

}  // namespace moraine
