#include "step/stages.hpp"

#include <fmt/core.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "probes/point_probe.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

std::string pressure_reached(PressureLimit const& limit, Simulation const& simulation) {
  Numerics const& numerics = simulation.model().numerics;
  PointState const state = probe_point(simulation.particles(), simulation.search(), numerics.kernel,
                                       numerics.smoothing_length(), limit.position);
  bool const reached = limit.above ? state.pressure > limit.pressure
                                   : state.pressure < limit.pressure;  // never where it is NaN
  if (!reached) return "";
  return fmt::format("pressure {:.4g} Pa is {} {:.4g} Pa", state.pressure,
                     limit.above ? "above" : "below", limit.pressure);
}

}  // namespace

std::string Stages::ended(Simulation const& simulation) {
  if (index_ + 1 >= stages_.size()) return "";
  StageEnd const& end = current()->end;
  double const time = simulation.time();
  if (time - began_ >= end.after) return fmt::format("{:.4g} s are over", end.after);
  if (simulation.step() % look_interval != 0) return "";
  if (end.rms_speed_below > 0.0) {
    ConservedSums const sums = simulation.sums();
    double const speed = std::sqrt(2.0 * sums.kinetic_energy / sums.mass);
    if (!(speed < end.rms_speed_below)) fast_until_ = time;
    if (time - fast_until_ >= end.steady_for && time > began_)
      return fmt::format("root-mean-square speed {:.4g} m/s, below {:.4g} m/s for {:.4g} s", speed,
                         end.rms_speed_below, time - fast_until_);
  }
  return end.pressure ? pressure_reached(*end.pressure, simulation) : "";
}

void Stages::begin_first() {
  if (!stages_.empty()) events_.push_back({current()->name, 0.0, 0, "start of the run"});
}

void Stages::begin_next(double time, std::uint64_t step, std::string cause) {
  ++index_;
  began_ = time;
  fast_until_ = time;
  events_.push_back({current()->name, time, step, std::move(cause)});
}

void Stages::exchange(Archive& archive) {
  std::uint64_t index = index_;
  archive.number("stages/index", index);
  archive.number("stages/began", began_);
  archive.number("stages/fast_until", fast_until_);
  std::vector<double> times;
  std::vector<std::uint64_t> steps;
  std::string causes;
  for (StageEvent const& event : events_) {
    times.push_back(event.time);
    steps.push_back(event.step);
    causes += event.cause + '\n';
  }
  archive.array("stages/event_times", "s", times);
  archive.array("stages/event_steps", "", steps);
  archive.text("stages/event_causes", causes);
  if (!archive.restoring()) return;
  if (index > 0 && index >= stages_.size())
    throw std::runtime_error("stages and case do not belong together");
  index_ = index;
  events_.clear();
  std::istringstream lines(causes);
  for (std::size_t k = 0; k < times.size() && k < steps.size() && k < stages_.size(); ++k) {
    StageEvent event{stages_[k].name, times[k], steps[k], ""};
    std::getline(lines, event.cause);
    events_.push_back(std::move(event));
  }
}

}  // namespace moraine
