// What is said when guards stop a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "step/guard.hpp"
#include "step/model.hpp"
#include "step/simulation_error.hpp"
#include "step/time_step.hpp"

namespace moraine {

/// The last few time steps and who asked for them, for those who want to know how it came.
class VoteHistory {
 public:
  static constexpr std::size_t length = 5;

  void note(Vote const& vote);
  /// "1.2e-05 s (motion of particle 7), ...", the oldest first; empty before the first step.
  std::string text() const;
  void exchange(Archive& archive);

 private:
  std::array<Vote, length> votes_;  // in a ring
  std::uint64_t noted_ = 0;
};

/// When and how a run stands while guards look at it.
struct GuardMoment {
  Model const& model;
  double time = 0.0;       // s
  std::uint64_t step = 0;  // whole steps done
  Vote const& vote;        // of the step being done
  VoteHistory const& votes;
};

/// One block of lines: of each finding the worst particle with id, material, place, what is wrong,
/// time, step and who limits the time step; some more particles; the last votes. All particles are
/// flagged. `findings` in the order of the table of guards; at least one.
SimulationError error_of(GuardMoment const& at, std::vector<Finding> findings);

}  // namespace moraine
