#include "setup/case_report.hpp"

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "setup/build_model.hpp"
#include "setup/case_size.hpp"
#include "setup/case_warnings.hpp"
#include "step/simulation.hpp"
#include "step/simulation_error.hpp"

namespace moraine {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double timing_seconds = 0.5;  // short beside a run, long beside the clock
constexpr int least_timed_steps = 2;
constexpr int most_timed_steps = 50;

void count_particles(Case const& c, ParticleStore const& store, CaseReport& report) {
  for (auto const& material : c.materials) report.fluid.push_back({material.name, 0});
  Range const fluid = store.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i)
    ++report.fluid[store.material()[i]].particles;
  report.walls = store.range(Kind::wall).size();
}

void time_steps(Simulation& simulation, CaseReport& report) {
  simulation.advance();
  report.time_step = simulation.time_step();
  report.limited_by = simulation.vote().reason;
  report.steps = std::ceil(simulation.model().time.end / report.time_step);
  auto const start = Clock::now();
  double seconds = 0.0;
  while (simulation.running() && report.timed_steps < most_timed_steps &&
         (report.timed_steps < least_timed_steps || seconds < timing_seconds)) {
    simulation.advance();
    ++report.timed_steps;
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  if (report.timed_steps > 0) report.seconds_per_step = seconds / report.timed_steps;
}

[[noreturn]] void refuse_start(Case const& c, SimulationError const& error) {
  throw InputErrors({problem_of(c, "region", fmt::format("at the start: {}", error.what()))});
}

Simulation started(Case const& c) {
  try {
    return Simulation(build_model(c));
  } catch (SimulationError const& error) {
    refuse_start(c, error);
  }
}

std::string duration_text(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.2g} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.2g} min", seconds / 60.0);
  return fmt::format("{:.3g} h", seconds / 3600.0);
}

// Names of files need not be UTF-8.
std::string dumped(nlohmann::ordered_json const& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

nlohmann::ordered_json problem_json(InputProblem const& problem) {
  return {{"file", problem.file},
          {"line", problem.line},
          {"column", problem.column},
          {"key", problem.key},
          {"text", format(problem)}};
}

}  // namespace

CaseReport report_case(Case const& c) {
  CaseReport report;
  Simulation simulation = started(c);
  count_particles(c, simulation.particles(), report);
  report.bytes = estimate_size(c).bytes;
  report.warnings = warnings_at_start(c, simulation);
  try {
    time_steps(simulation, report);
  } catch (SimulationError const& error) {
    report.warnings.push_back(problem_of(c, "time", error.what()));
  }
  if (report.time_step > 0.0) add_output_warnings(c, report.time_step, report.warnings);
  return report;
}

std::string to_text(CaseReport const& report) {
  std::string text;
  for (auto const& [material, particles] : report.fluid)
    text += fmt::format("particles   {} of {}\n", particles, material);
  text += fmt::format("            {} of walls\n", report.walls);
  text += fmt::format("memory      about {:.3g} MB\n", report.bytes / 1e6);
  text += fmt::format("time step   {:.3g} s at the start, limited by {}\n", report.time_step,
                      report.limited_by);
  text += fmt::format("steps       about {:.0f}, if all were like the first\n", report.steps);
  text += fmt::format(
      "wall time   about {} on this machine without output, estimated from {} "
      "steps of {:.3g} ms\n",
      duration_text(report.wall_time()), report.timed_steps, 1e3 * report.seconds_per_step);
  text += fmt::format("warnings    {}\n", report.warnings.size());
  for (auto const& warning : report.warnings) text += fmt::format("{}\n", format(warning));
  return text;
}

std::string to_json(CaseReport const& report) {
  nlohmann::ordered_json json{{"mistakes", nlohmann::ordered_json::array()}};
  auto& fluid = json["fluid_particles"] = nlohmann::ordered_json::object();
  for (auto const& [material, particles] : report.fluid) fluid[material] = particles;
  json["wall_particles"] = report.walls;
  json["memory_bytes"] = report.bytes;
  json["time_step_s"] = report.time_step;
  json["time_step_limited_by"] = report.limited_by;
  json["estimated_steps"] = report.steps;
  json["seconds_per_step"] = report.seconds_per_step;
  json["timed_steps"] = report.timed_steps;
  json["estimated_wall_time_s"] = report.wall_time();
  auto& warnings = json["warnings"] = nlohmann::ordered_json::array();
  for (auto const& warning : report.warnings) warnings.push_back(problem_json(warning));
  return dumped(json);
}

std::string mistakes_to_json(InputErrors const& errors) {
  nlohmann::ordered_json json{{"mistakes", nlohmann::ordered_json::array()}};
  for (auto const& problem : errors.problems()) json["mistakes"].push_back(problem_json(problem));
  return dumped(json);
}

}  // namespace moraine
