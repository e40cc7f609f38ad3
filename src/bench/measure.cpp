#include "bench/measure.hpp"

#include <algorithm>
#include <chrono>

#include "base/parallel_for.hpp"
#include "bench/process.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

// Pairs are counted this many times per measurement, evenly spaced: their number changes slowly.
constexpr int most_intervals = 20;
constexpr int least_interval = 10;     // steps
constexpr int open_end_interval = 50;  // steps, where the number of steps is not known before

int interval_of(Workload const& workload) {
  if (workload.steps == 0) return open_end_interval;
  int const even = (workload.steps + most_intervals - 1) / most_intervals;
  return std::min(workload.steps, std::max(even, least_interval));
}

/// Steps under the clock; counting pairs in between is not.
class TimedSteps {
 public:
  TimedSteps(Simulation& simulation, Measurement& measured)
      : simulation_(simulation), measured_(measured), pairs_(count()) {}

  void run(int steps) {
    using Clock = std::chrono::steady_clock;
    double const processor_before = processor_seconds();
    auto const before = Clock::now();
    int done = 0;
    for (; done < steps && simulation_.running(); ++done) simulation_.advance();
    double const seconds = std::chrono::duration<double>(Clock::now() - before).count();
    measured_.wall_seconds += seconds;
    measured_.processor_seconds += processor_seconds() - processor_before;
    measured_.steps += static_cast<std::uint64_t>(done);
    double const now = count();
    double const pairs = 0.5 * (pairs_ + now) * done;
    pairs_ = now;
    measured_.pairs += pairs;
    measured_.fastest_pairs_per_second_per_core =
        std::max(measured_.fastest_pairs_per_second_per_core, pairs / seconds / measured_.threads);
  }

 private:
  double count() const {
    return static_cast<double>(simulation_.pairs().count_pairs(simulation_.search()));
  }

  Simulation& simulation_;
  Measurement& measured_;
  double pairs_;
};

std::vector<double> seconds_so_far(Timers const& timers) {
  std::vector<double> seconds;
  for (TimerEntry const& entry : timers.entries()) seconds.push_back(entry.seconds());
  return seconds;
}

}  // namespace

Measurement measure(Workload const& workload) {
  std::size_t const memory_before = resident_memory().now;
  Measurement measured;
  measured.name = workload.name;
  measured.threads = static_cast<int>(thread_count());
  Simulation simulation(build_model(workload.make()));
  for (int k = 0; k < workload.warm_up && simulation.running(); ++k) simulation.advance();
  measured.warm_up_steps = simulation.step();
  measured.simulated_from = simulation.time();
  std::uint64_t const rebuilds_before = simulation.search().rebuilds();
  std::vector<double> const seconds_before = seconds_so_far(simulation.timers());

  TimedSteps timed(simulation, measured);
  auto const wanted = static_cast<std::uint64_t>(workload.steps);
  auto const interval = static_cast<std::uint64_t>(interval_of(workload));
  while (simulation.running() && (wanted == 0 || measured.steps < wanted))
    timed.run(
        static_cast<int>(wanted == 0 ? interval : std::min(interval, wanted - measured.steps)));

  measured.pairs_per_second_per_core = measured.pairs / measured.wall_seconds / measured.threads;
  measured.rebuilds = simulation.search().rebuilds() - rebuilds_before;
  measured.simulated_to = simulation.time();
  measured.particles = simulation.particles().range(Kind::fluid).size();
  measured.wall_particles = simulation.particles().range(Kind::wall).size();
  std::size_t k = 0;
  for (TimerEntry const& entry : simulation.timers().entries())
    measured.actions.push_back({entry.label, entry.seconds() - seconds_before[k++]});
  std::size_t const peak = resident_memory().peak;
  measured.peak_bytes = peak > memory_before ? peak - memory_before : 0;
  measured.counted_bytes = simulation.bytes();
  return measured;
}

}  // namespace moraine
