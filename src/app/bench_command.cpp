// moraine bench: speed and memory of this program on this machine.
#include <fmt/core.h>
#include <omp.h>

#include <algorithm>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "bench/bench_report.hpp"
#include "bench/process.hpp"
#include "bench/roof.hpp"
#include "output/manifest.hpp"

namespace moraine {
namespace {

constexpr std::string_view roof_name = "roof";
constexpr double roof_seconds = 3.0;  // per line

void say_list() {
  for (Workload const& workload : workloads())
    fmt::print("{:<22} {}{}\n", workload.name, workload.description, workload.usual ? " *" : "");
  fmt::print("{:<22} the pair loop alone on states of the dam breaks and in the cache\n",
             roof_name);
  fmt::print("\n* without names, these are run\n");
}

[[noreturn]] void refuse(std::string const& name) {
  std::vector<std::string_view> known{roof_name};
  for (Workload const& workload : workloads()) known.push_back(workload.name);
  throw InputErrors(
      {{"moraine bench", 0, 0, "", name, "is not a workload", name_hint(name, known)}});
}

Workload with(Workload workload, BenchOptions const& options) {
  if (options.steps > 0) workload.steps = options.steps;
  if (options.warm_up >= 0) workload.warm_up = options.warm_up;
  return workload;
}

std::vector<Workload> chosen(BenchOptions const& options) {
  std::vector<Workload> result;
  for (std::string const& name : options.names) {
    if (name == roof_name) continue;
    auto const found = find_workload(name);
    if (!found) refuse(name);
    result.push_back(with(*found, options));
  }
  if (options.names.empty())
    for (Workload const& workload : workloads())
      if (workload.usual) result.push_back(with(workload, options));
  return result;
}

/// A workload that is alone runs in this process, where profilers see it.
Measurement measure_apart(Workload const& workload, bool alone) {
  if (alone) return measure(workload);
  return measurement_from_json(
      nlohmann::ordered_json::parse(in_child([&] { return to_json(measure(workload)).dump(); })));
}

void say(std::vector<Measurement> const& measured) {
  BuildInfo const build = build_info();
  fmt::print("moraine {} ({}), {}, {}, {} threads\n\n{}\n", build.version, build.git_revision,
             build.simd, processor_name(), omp_get_max_threads(), figures_table(measured));
  for (Measurement const& m : measured) {
    fmt::print("{}", actions_table(m));
    if (m.steps < least_steps)
      fmt::print("  only {} steps: a fair figure needs {}\n", m.steps, least_steps);
    fmt::print("\n");
  }
  fmt::print(
      "pairs: directed, of a fluid particle with a fluid or wall particle closer than 2 h, once "
      "per "
      "step\nper cpu s: per second of processor time, threads that wait included; where it is far "
      "above "
      "the rate\nper core, others use this machine\nbytes: growth of the resident memory of the "
      "process, per "
      "fluid particle\n");
}

}  // namespace

int run_bench(BenchOptions const& options) {
  if (options.list) {
    say_list();
    return ExitCode::done;
  }
  if (options.threads > 0) omp_set_num_threads(options.threads);
  int const threads = omp_get_max_threads();
  bool const roof = std::count(options.names.begin(), options.names.end(), roof_name) > 0;
  auto const wanted = chosen(options);
  std::vector<Measurement> measured;
  for (Workload const& workload : wanted) {
    if (wanted.size() > 1) fmt::print(stderr, "{} ...\n", workload.name);
    measured.push_back(measure_apart(workload, wanted.size() == 1));
  }
  std::vector<RoofLine> lines;
  if (roof) lines = measure_roof_lines(threads, roof_seconds);

  if (options.json) {
    nlohmann::ordered_json json{{"machine", machine_to_json(threads)},
                                {"workloads", nlohmann::ordered_json::array()}};
    for (Measurement const& m : measured) json["workloads"].push_back(to_json(m));
    if (roof) json["roof"] = to_json(std::span<RoofLine const>(lines));
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
  }
  if (!measured.empty()) say(measured);
  if (roof) fmt::print("{}", roof_table(lines));
  return ExitCode::done;
}

}  // namespace moraine
