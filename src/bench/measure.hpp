// Measures one workload: speed of the step, where its time goes, memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/workload.hpp"

namespace moraine {

/// Fewer timed steps say little: a list lives for tens of steps.
inline constexpr int least_steps = 500;

/// Time of one labelled action of the step, over all timed steps.
struct ActionTime {
  std::string label;
  double seconds = 0.0;
};

/// What one workload gave. Particles are those of the fluid at the end of the measurement. The
/// figure of merit is `pairs_per_second_per_core`; docs/performance.md defines it.
struct Measurement {
  std::string name;
  std::uint64_t particles = 0;
  std::uint64_t wall_particles = 0;
  int threads = 1;
  std::uint64_t warm_up_steps = 0;
  std::uint64_t steps = 0;         // timed
  std::uint64_t rebuilds = 0;      // of the neighbour lists, in the timed steps
  double simulated_from = 0.0;     // s, where the clock started
  double simulated_to = 0.0;       // s
  double wall_seconds = 0.0;       // of the timed steps alone
  double processor_seconds = 0.0;  // the same, of all threads
  double pairs = 0.0;              // directed pairs closer than 2 h, summed over the timed steps
  double pairs_per_second_per_core = 0.0;
  double fastest_pairs_per_second_per_core = 0.0;  // the best of the intervals between counts
  std::size_t peak_bytes = 0;     // growth of resident memory since before the case was read
  std::size_t counted_bytes = 0;  // Simulation::bytes()
  std::vector<ActionTime> actions;

  double neighbours() const { return pairs / static_cast<double>(steps * particles); }
  double particle_steps_per_second() const {
    return static_cast<double>(particles) * static_cast<double>(steps) / wall_seconds;
  }
  /// What the cores would do if nobody else used them; waiting threads count as working.
  double pairs_per_processor_second() const { return pairs / processor_seconds; }
  double bytes_per_particle() const {
    return static_cast<double>(peak_bytes) / static_cast<double>(particles);
  }
  double bytes_per_particle_with_walls() const {
    return static_cast<double>(peak_bytes) / static_cast<double>(particles + wall_particles);
  }
};

/// Runs a workload from its initial state in this process, with the present number of threads.
/// Memory is told apart only in a process that ran nothing before. Throws SimulationError.
Measurement measure(Workload const& workload);

}  // namespace moraine
