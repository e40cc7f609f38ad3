#include "app/run_words.hpp"

#include <fmt/core.h>

#include "base/simd_width.hpp"
#include "output/printable.hpp"
#include "output/timing_table.hpp"

namespace moraine {

ProgressReport progress_of(Simulation const& simulation) {
  return {simulation.time(),        simulation.model().time.end,
          simulation.step(),        simulation.time_step(),
          simulation.vote().reason, simulation.particles().range(Kind::fluid).size()};
}

void say_start(Run const& run, int threads) {
  auto const& store = run.simulation.particles();
  Case const& c = run.c;
  fmt::print(
      "{}\n{}D, {} fluid and {} wall particles, spacing {:.4g} m, h {:.4g} m, kernel {}, {} "
      "threads, {}\n",
      printable(c.title.empty() ? c.file : c.title), c.dimension, store.range(Kind::fluid).size(),
      store.range(Kind::wall).size(), c.numerics.spacing, c.numerics.smoothing_length(),
      kernel_name(c.numerics.kernel), threads, simd_flavour);
  if (double const finest = run.simulation.model().finest_spacing; finest < c.numerics.spacing)
    fmt::print("finest spacing of a region {:.4g} m\n", finest);
  if (StartInfo const& from = c.start.info; !c.start.run.empty())
    fmt::print("particles from {} of {}, time {:.6g} s, step {}\n", from.checkpoint, from.run,
               from.time, from.step);
}

std::size_t say_stages(Simulation const& simulation, std::size_t told, Progress& progress) {
  auto const& events = simulation.stage_events();
  for (; told < events.size(); ++told) {
    progress.clear();
    StageEvent const& event = events[told];
    fmt::print("stage \"{}\" begins at time {:.6g} s, step {}: {}\n", printable(event.stage),
               event.time, event.step, event.cause);
  }
  return told;
}

void say_end(Run const& run, Saver const& saver, EndWords const& end) {
  Simulation const& simulation = run.simulation;
  fmt::print("\n{}: time {:.6g} s, {} steps in {:.2f} s\n", end.reason, simulation.time(),
             simulation.step(), end.seconds);
  if (simulation.lost().count > 0)
    fmt::print("{} particles left the domain and were removed ({:.4g} kg, {:.4g} J)\n",
               simulation.lost().count, simulation.lost().mass, simulation.lost().energy);
  if (!simulation.running() && simulation.stages_to_come() > 0)
    fmt::print("{} stages never began: the condition of the one before did not come true\n",
               simulation.stages_to_come());
  SmoothingClips const& clips = simulation.smoothing_clips();
  if (clips.at_least + clips.at_most > 0)
    fmt::print(
        "smoothing lengths were cut off: of up to {} particles at {:.4g} m "
        "(resolution.smoothing.least), of up to {} at {:.4g} m (most)\n",
        clips.at_least, simulation.model().numerics.least_smoothing_length(), clips.at_most,
        simulation.model().numerics.largest_smoothing_length());
  for (std::string const& remark : run.recorder.remarks()) fmt::print("{}\n", printable(remark));
  std::string const folder = run.folder.string();
  fmt::print(
      "\n{}\nresults in {}: {}particles.pvd (ParaView), gauges.csv, sums.csv; pictures: moraine "
      "plot {}\n",
      timing_table(all_timers(run, saver), end.seconds), folder,
      end.page ? "report.html (any browser), " : "", folder);
  if (simulation.running()) fmt::print("to go on: moraine resume {}\n", folder);
}

}  // namespace moraine
