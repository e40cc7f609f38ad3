#include "output/run_status.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "output/atomic_file.hpp"
#include "output/manifest.hpp"
#include "step/guard.hpp"
#include "step/guard_findings.hpp"

namespace moraine {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::chrono::seconds interval{1};
constexpr std::chrono::seconds averaging_time{3};

double seconds(std::chrono::steady_clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

Json number_or_null(std::optional<double> value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json votes_of(std::vector<VoteShare> const& votes) {
  auto list = Json::array();
  for (VoteShare const& vote : votes)
    list.push_back({{"reason", vote.reason},
                    {"steps", vote.steps},
                    {"least_time_step_s", number_or_null(vote.least_time_step)}});
  return list;
}

/// Why an optional guard says nothing about a run; empty where it looks.
std::string_view not_looking(Guard guard, Model const& model) {
  if (!model.guards.looks(guard)) return "switched off";
  if (guard == Guard::budget && !has_budget(model))
    return "not known: gravity along periodic sides";
  if (guard == Guard::walls && !model.walls.faces.empty()) return "sees walls of dummies only";
  return "";
}

Json guards_of(Simulation const& simulation) {
  auto list = Json::array();
  auto const& parts = simulation.guards().largest_parts();
  for (GuardInfo const& guard : guard_table)
    if (guard.optional)
      list.push_back({{"name", guard.name},
                      {"looks_at", guard.looks_at},
                      {"not_looking", not_looking(guard.guard, simulation.model())},
                      {"largest_part_of_bound",
                       number_or_null(parts[static_cast<std::size_t>(guard.guard)])}});
  return list;
}

Json timing_of(Timers const& timers) {
  auto list = Json::array();
  for (TimerEntry const& entry : timers.entries())
    list.push_back({{"label", entry.label}, {"seconds", entry.seconds()}, {"calls", entry.calls}});
  return list;
}

Json lost_of(LostParticles const& lost) {
  return {{"particles", lost.count}, {"mass_kg", lost.mass}, {"energy_J", lost.energy}};
}

}  // namespace

std::string_view phase_name(RunPhase phase) {
  constexpr std::array<std::string_view, 4> names{"running", "ended", "stopped", "broken"};
  return names[static_cast<std::size_t>(phase)];
}

void write_status(std::filesystem::path const& path, Simulation const& simulation,
                  RunStatus const& status) {
  SmoothingClips const& clips = simulation.smoothing_clips();
  Json const json{
      {"state", phase_name(status.phase)},
      {"reason", status.reason},
      {"written_utc", utc_now()},
      {"time_s", simulation.time()},
      {"end_time_s", simulation.model().time.end},
      {"step", simulation.step()},
      {"time_step_s", number_or_null(simulation.time_step())},
      {"limited_by", simulation.vote().reason},
      {"particles", simulation.particles().range(Kind::fluid).size()},
      {"wall_time_s", status.wall_time},
      {"steps_per_second", number_or_null(status.steps_per_second)},
      {"time_left_s", number_or_null(status.time_left)},
      {"stages_to_come", simulation.stages_to_come()},
      {"lost", lost_of(simulation.lost())},
      {"smoothing_clips", {{"at_least", clips.at_least}, {"at_most", clips.at_most}}},
      {"votes", votes_of(status.votes)},
      {"guards", guards_of(simulation)},
      {"timing", timing_of(status.timers)},
      {"remarks", status.remarks},
  };
  AtomicFile file(path);
  file.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

bool StatusPace::due() {
  auto const now = Clock::now();
  if (last_ && now - *last_ < interval) return false;
  last_ = now;
  return true;
}

void StatusPace::measure(Simulation const& simulation) {
  auto const now = Clock::now();
  samples_.push_back({now, simulation.time(), simulation.step()});
  while (samples_.size() > 2 && now - samples_[1].clock > averaging_time)
    samples_.erase(samples_.begin());
  Sample const& first = samples_.front();
  double const elapsed = seconds(now - first.clock);
  if (elapsed <= 0.0 || simulation.step() == first.step) return;
  steps_per_second_ = static_cast<double>(simulation.step() - first.step) / elapsed;
  double const speed = (simulation.time() - first.time) / elapsed;
  if (speed > 0.0) time_left_ = (simulation.model().time.end - simulation.time()) / speed;
}

}  // namespace moraine
