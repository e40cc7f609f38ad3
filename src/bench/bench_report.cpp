#include "bench/bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>

#include "bench/process.hpp"
#include "output/manifest.hpp"

namespace moraine {
namespace {

using Json = nlohmann::ordered_json;

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

double steps_per_rebuild(Measurement const& m) {
  return static_cast<double>(m.steps) / static_cast<double>(m.rebuilds);
}

}  // namespace

Json to_json(Measurement const& m) {
  Json seconds = Json::object(), shares = Json::object();
  for (ActionTime const& action : m.actions) {
    seconds[action.label] = action.seconds;
    shares[action.label] = share(action.seconds, m.wall_seconds);
  }
  return {
      {"name", m.name},
      {"particles", m.particles},
      {"wall_particles", m.wall_particles},
      {"neighbours", m.neighbours()},
      {"threads", m.threads},
      {"warm_up_steps", m.warm_up_steps},
      {"steps", m.steps},
      {"rebuilds", m.rebuilds},
      {"steps_per_rebuild", m.rebuilds > 0 ? Json(steps_per_rebuild(m)) : Json()},
      {"simulated_from_s", m.simulated_from},
      {"simulated_to_s", m.simulated_to},
      {"wall_seconds", m.wall_seconds},
      {"processor_seconds", m.processor_seconds},
      {"neighbour_interactions", m.pairs},
      {"neighbour_interactions_per_second_per_core", m.pairs_per_second_per_core},
      {"neighbour_interactions_per_processor_second", m.pairs_per_processor_second()},
      {"fastest_interval_interactions_per_second_per_core", m.fastest_pairs_per_second_per_core},
      {"particle_steps_per_second", m.particle_steps_per_second()},
      {"peak_bytes", m.peak_bytes},
      {"bytes_per_particle", m.bytes_per_particle()},
      {"bytes_per_particle_with_walls", m.bytes_per_particle_with_walls()},
      {"simulation_bytes", m.counted_bytes},
      {"action_seconds", seconds},
      {"action_shares", shares}};
}

Measurement measurement_from_json(Json const& json) {
  Measurement m;
  json.at("name").get_to(m.name);
  json.at("particles").get_to(m.particles);
  json.at("wall_particles").get_to(m.wall_particles);
  json.at("threads").get_to(m.threads);
  json.at("warm_up_steps").get_to(m.warm_up_steps);
  json.at("steps").get_to(m.steps);
  json.at("rebuilds").get_to(m.rebuilds);
  json.at("simulated_from_s").get_to(m.simulated_from);
  json.at("simulated_to_s").get_to(m.simulated_to);
  json.at("wall_seconds").get_to(m.wall_seconds);
  json.at("processor_seconds").get_to(m.processor_seconds);
  json.at("neighbour_interactions").get_to(m.pairs);
  json.at("neighbour_interactions_per_second_per_core").get_to(m.pairs_per_second_per_core);
  json.at("fastest_interval_interactions_per_second_per_core")
      .get_to(m.fastest_pairs_per_second_per_core);
  json.at("peak_bytes").get_to(m.peak_bytes);
  json.at("simulation_bytes").get_to(m.counted_bytes);
  for (auto const& [label, seconds] : json.at("action_seconds").items())
    m.actions.push_back({label, seconds.get<double>()});
  return m;
}

Json machine_to_json(int threads) {
  BuildInfo const build = build_info();
  return {{"version", build.version},   {"git_revision", build.git_revision},
          {"compiler", build.compiler}, {"compiler_flags", build.compiler_flags},
          {"simd", build.simd},         {"processor", processor_name()},
          {"threads", threads},         {"time_utc", utc_now()}};
}

Json to_json(std::span<RoofLine const> lines) {
  Json result = Json::array();
  for (RoofLine const& line : lines)
    result.push_back(
        {{"name", line.name},
         {"threads", line.threads},
         {"pairs", line.pairs},
         {"listed_per_pair", line.listed_per_pair},
         {"pairs_per_second_per_core", line.median_pairs_per_second_per_core},
         {"fastest_pairs_per_second_per_core", line.fastest_pairs_per_second_per_core}});
  return result;
}

std::string figures_table(std::span<Measurement const> measured) {
  constexpr auto heading =
      "{:<20} {:>9} {:>9} {:>6} {:>6} {:>6} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n";
  std::string table =
      fmt::format(heading, "workload", "fluid", "wall", "neigh", "steps", "steps/", "seconds",
                  "M pairs/", "fastest", "M pairs/", "M part.", "bytes/");
  table += fmt::format(heading, "", "particles", "particles", "bours", "", "list", "", "s/core",
                       "interval", "cpu s", "steps/s", "particle");
  for (Measurement const& m : measured)
    fmt::format_to(std::back_inserter(table),
                   "{:<20} {:>9} {:>9} {:>6.1f} {:>6} {:>6} {:>8.2f} {:>8.1f} {:>8.1f} {:>8.1f} "
                   "{:>8.3f} {:>8.0f}\n",
                   m.name, m.particles, m.wall_particles, m.neighbours(), m.steps,
                   m.rebuilds > 0 ? fmt::format("{:.1f}", steps_per_rebuild(m))
                                  : ">" + std::to_string(m.steps),
                   m.wall_seconds, 1e-6 * m.pairs_per_second_per_core,
                   1e-6 * m.fastest_pairs_per_second_per_core,
                   1e-6 * m.pairs_per_processor_second(), 1e-6 * m.particle_steps_per_second(),
                   m.bytes_per_particle());
  return table;
}

std::string actions_table(Measurement const& m) {
  std::vector<ActionTime> rows = m.actions;
  double const covered =
      std::accumulate(rows.begin(), rows.end(), 0.0,
                      [](double sum, ActionTime const& action) { return sum + action.seconds; });
  std::stable_sort(rows.begin(), rows.end(),
                   [](ActionTime const& a, ActionTime const& b) { return a.seconds > b.seconds; });
  rows.push_back({"other", m.wall_seconds - covered});
  rows.push_back({"total", m.wall_seconds});
  std::string table = fmt::format(
      "{}: {:.4g} to {:.4g} s simulated, {:.2f} s of processor time on {} threads\n"
      "{:<28} {:>10} {:>7} {:>12}\n",
      m.name, m.simulated_from, m.simulated_to, m.processor_seconds, m.threads, "  action",
      "seconds", "%", "ms per step");
  for (ActionTime const& row : rows)
    fmt::format_to(std::back_inserter(table), "  {:<26} {:>10.3f} {:>7.1f} {:>12.3f}\n", row.label,
                   row.seconds, 100.0 * share(row.seconds, m.wall_seconds),
                   1e3 * row.seconds / static_cast<double>(m.steps));
  return table;
}

}  // namespace moraine
