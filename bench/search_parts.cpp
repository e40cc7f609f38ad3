// Parts of the neighbour search: check of the lists in use, rebuilding, sorting, one list.
#include <numeric>
#include <random>
#include <vector>

#include "search/neighbour_list.hpp"
#include "state.hpp"

namespace moraine::parts {
namespace {

/// Nothing moved: positions are read and compared with those of the last rebuild.
void displacement_check(benchmark::State& run) {
  State state = dam_break_state(static_cast<int>(run.range(0)));
  for (auto _ : run) state.search.refresh(state.model.particles);
  if (state.search.rebuilds() != 1) run.SkipWithError("the lists were rebuilt");
  run.counters["particles"] = per_second(static_cast<double>(state.fluid()));
}

/// One particle jumps back and forth by a support radius: everything is made anew.
void rebuild(benchmark::State& run) {
  State state = dam_break_state(static_cast<int>(run.range(0)));
  ParticleStore& store = state.model.particles;
  double jump = kernel_support * state.model.numerics.smoothing_length();
  for (auto _ : run) {
    for (std::size_t i = 0; i < state.fluid(); ++i)
      if (store.id()[i] == 0) store.component(Field::position, 0)[i] += jump;
    jump = -jump;
    if (!state.search.refresh(store)) run.SkipWithError("the lists were not rebuilt");
  }
  run.counters["particles"] = per_second(static_cast<double>(state.fluid()));
}

BENCHMARK(displacement_check)->Arg(2)->Arg(3);
BENCHMARK(rebuild)->Arg(2)->Arg(3);

/// Points of a jittered cubic lattice in units, 24 per edge, in a grid of half-radius cells.
struct Points {
  static constexpr int edge = 24;
  static constexpr Units spacing = 1 << 20;
  static constexpr double radius = 3.464 * 1.04 * spacing;

  Points() {
    std::mt19937 random(1);
    for (int k = 0; k < edge * edge * edge; ++k) {
      int const cell[3] = {k % edge, k / edge % edge, k / edge / edge};
      for (std::size_t axis = 0; axis < 3; ++axis)
        x[axis].push_back(cell[axis] * spacing + static_cast<Units>(random() % (spacing / 4)));
    }
    key.resize(x[0].size());
    std::iota(key.begin(), key.end(), std::uint64_t{0});
    shape = GridShape::over({0, 0, 0}, {edge * spacing, edge * spacing, edge * spacing}, 3,
                            radius / 2.0, 1'000'000);
  }
  auto sort(CellSort& sort_by_cells, CellGrid& grid) const {
    return sort_by_cells(shape, 3, {x[0], x[1], x[2]}, key, grid);
  }

  std::array<std::vector<Units>, 3> x;
  std::vector<std::uint64_t> key;
  GridShape shape;
};

void sort_by_cells(benchmark::State& run) {
  Points const points;
  CellGrid grid;
  CellSort sort;
  for (auto _ : run) points.sort(sort, grid);
  run.counters["particles"] = per_second(static_cast<double>(points.key.size()));
}

void collect_neighbours(benchmark::State& run) {
  Points const points;
  CellGrid grid;
  CellSort sort;
  std::array<std::vector<Units>, 3> sorted;
  for (std::uint32_t const k : points.sort(sort, grid))
    for (std::size_t axis = 0; axis < 3; ++axis) sorted[axis].push_back(points.x[axis][k]);
  for (auto& axis : sorted) axis.resize(axis.size() + CellPoints::padding);
  NeighbourFinder<3> const find({grid, {sorted[0], sorted[1], sorted[2]}}, Points::radius);
  std::size_t const middle = points.key.size() / 2 + Points::edge * Points::edge / 2;
  UnitPoint const x{points.x[0][middle], points.x[1][middle], points.x[2][middle]};
  CandidateCache cache;
  IndexBuffer buffer;
  std::size_t found = 0;
  for (auto _ : run) {
    buffer.clear();
    find(x, static_cast<std::uint32_t>(middle), cache, buffer);
    found = buffer.content().size();
  }
  run.counters["neighbours"] = per_second(static_cast<double>(found));
}

BENCHMARK(sort_by_cells);
BENCHMARK(collect_neighbours);

}  // namespace
}  // namespace moraine::parts
