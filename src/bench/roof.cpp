#include "bench/roof.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <iterator>

#include "bench/workload.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "step/simulation_setup.hpp"

namespace moraine {
namespace {

std::size_t listed(NeighbourList const& lists) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < lists.size(); ++i) sum += lists.of(i).count;
  return sum * lists.lanes();
}

/// The state of a case after some steps: particles no longer on a lattice, walls with pressure.
Model after_steps(Case const& c, int steps) {
  Simulation simulation(build_model(c));
  for (int k = 0; k < steps; ++k) simulation.advance();
  return simulation.model();
}

/// A block whose lists and records, images included, fit 1 MiB.
constexpr int small_block = 8;

}  // namespace

RoofLine measure_roof(std::string name, Model model, SchemeName scheme, int threads,
                      double seconds) {
  using Clock = std::chrono::steady_clock;
  int const threads_before = omp_get_max_threads();
  omp_set_num_threads(threads);
  ParticleStore& store = model.particles;
  Search search(search_settings(model));
  search.refresh(store);
  auto const pairs = make_pair_backend(model.dimension, model.flavour(), scheme,
                                       sweep_parameters(model), reference_densities(model));
  pairs->gather_fluid(store, search, 0.0);
  pairs->gather_walls(store, search, model.walls);

  RoofLine line{std::move(name), threads, pairs->count_pairs(search), 0.0, 0.0, 0.0};
  auto const entries = listed(search.fluid_fluid()) + listed(search.fluid_wall());
  line.listed_per_pair = static_cast<double>(entries) / static_cast<double>(line.pairs);
  // Sweeps of a small state are too short for the clock: time them by the million of pairs.
  auto const sweeps = std::max<std::uint64_t>(1, 10'000'000 / line.pairs);
  std::vector<double> rates;
  auto const start = Clock::now();
  while (std::chrono::duration<double>(Clock::now() - start).count() < seconds ||
         rates.size() < 5) {
    auto const before = Clock::now();
    for (std::uint64_t k = 0; k < sweeps; ++k) pairs->sweep(store, search);
    double const spent = std::chrono::duration<double>(Clock::now() - before).count();
    rates.push_back(static_cast<double>(line.pairs * sweeps) / spent / threads);
  }
  omp_set_num_threads(threads_before);
  std::sort(rates.begin(), rates.end());
  line.median_pairs_per_second_per_core = rates[rates.size() / 2];
  line.fastest_pairs_per_second_per_core = rates.back();
  return line;
}

std::vector<RoofLine> measure_roof_lines(int threads, double seconds_each) {
  std::vector<RoofLine> lines;
  auto const add = [&](std::string const& what, Model const& model, int with_threads) {
    lines.push_back(
        measure_roof(what + ", one liquid", model, SchemeName::liquid, with_threads, seconds_each));
    lines.push_back(measure_roof(what + ", any material", model, SchemeName::compressible,
                                 with_threads, seconds_each));
  };
  omp_set_num_threads(threads);
  auto const broken = after_steps(find_workload("dam-break-3d")->make(), 100);
  add("dam break 3D", broken, threads);
  if (threads > 1) add("dam break 3D", broken, 1);
  add("dam break 2D", after_steps(find_workload("dam-break-2d")->make(), 100), threads);
  add("dam break 3D double", after_steps(find_workload("dam-break-3d-double")->make(), 20),
      threads);
  add("small block 3D", build_model(periodic_block(3, small_block, Precision::mixed)), 1);
  add("small block 2D", build_model(periodic_block(2, 4 * small_block, Precision::mixed)), 1);
  return lines;
}

std::string roof_table(std::vector<RoofLine> const& lines) {
  std::string table = fmt::format("{:<34} {:>7} {:>11} {:>11} {:>15} {:>10}\n", "sweep alone",
                                  "threads", "pairs", "listed/pair", "M pairs/s/core", "fastest");
  for (RoofLine const& line : lines)
    fmt::format_to(std::back_inserter(table), "{:<34} {:>7} {:>11} {:>11.3f} {:>15.1f} {:>10.1f}\n",
                   line.name, line.threads, line.pairs, line.listed_per_pair,
                   1e-6 * line.median_pairs_per_second_per_core,
                   1e-6 * line.fastest_pairs_per_second_per_core);
  return table;
}

}  // namespace moraine
