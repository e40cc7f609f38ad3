// Looks at a run every so many steps and stops it where it has run away.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/archive.hpp"
#include "step/guard_bounds.hpp"
#include "step/guard_report.hpp"

namespace moraine {

class Simulation;

/// The optional guards of a run (docs/guards.md), what they must remember, and the last votes. They
/// read the state and never change it: a run has the same bits with and without them.
class Guards {
 public:
  /// Call when the rates of a state have been made anew: at the start, when a stage has begun.
  void begin(Simulation const& simulation);

  /// Call when the time step has been chosen.
  void note(Vote const& vote) { votes_.note(vote); }
  VoteHistory const& votes() const { return votes_; }

  /// Call at the end of each step, with the largest speed at its end [m/s]; looks where a look is
  /// due. Throws SimulationError with all that is found.
  void watch(Simulation const& simulation, double fastest);

  /// Looks now, and remembers nothing.
  void look(Simulation const& simulation) const;

  /// The largest part of its bound that each guard has seen, by flag_of(guard) - 1; 1 stops a run.
  /// Zero for guards that look at every step.
  std::array<double, guard_count> const& largest_parts() const { return parts_; }

  /// Saves or restores what is remembered; bounds follow from it and from the model.
  void exchange(Archive& archive, Model const& model);

 private:
  using Parts = std::array<double, guard_count>;
  struct Energy {
    double error = 0.0, scale = 0.0;  // J
  };

  Parts measure(Simulation const& simulation) const;
  double part_in_walls(Simulation const& simulation) const;
  Energy energy_of(Simulation const& simulation) const;
  double part_in_budget(Model const& model, Energy const& energy) const;
  void count_short_steps(Simulation const& simulation);
  void stop_where_due(Simulation const& simulation, Parts const& parts) const;

  StateRange start_;
  GuardBounds bounds_;
  VoteHistory votes_;
  Parts parts_{};
  double start_energy_ = 0.0;      // J, kinetic + internal + potential
  double energy_scale_ = 0.0;      // J, the largest so far
  double motion_ = 0.0;            // m, of the fastest particles since walls were looked at
  std::uint64_t short_steps_ = 0;  // in a row
  std::uint64_t begun_ = 0;        // how often rates have been made anew
};

}  // namespace moraine
