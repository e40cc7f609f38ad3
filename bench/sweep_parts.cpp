// The pair loop for every flavour, and its two halves: reading neighbours, arithmetic.
#include <bit>
#include <string>
#include <vector>

#include "base/aligned_vector.hpp"
#include "state.hpp"
#include "terms/schemes.hpp"
#include "terms/sweep.hpp"

namespace moraine {
namespace parts {

/// The records of a layout, but always the same ones, already in lanes.
template <class Layout>
struct Resident : Layout {};

/// Keeps a register from being known to the compiler; costs nothing.
template <class Real>
MORAINE_FORMULA void touch(Real& number) {
  asm volatile("" : "+v"(number.v));
}

}  // namespace parts

/// Found in place of the reading loop for resident layouts: the same calls without the loads.
template <class Real, class Layout, class Use>
MORAINE_FORMULA void for_each_lanes(NeighbourGroups const& list, SlotOf<Real> const*,
                                    Lanes<Real, parts::Resident<Layout>>& lanes, Use&& use) {
  // Ordinary numbers: zeros, infinities and the like may cost more or less. Positions are units.
  for (std::size_t n = 0; n < Layout::stride; ++n)
    lanes.packed[n] = Real(0.01f * static_cast<float>(n));
  for (std::size_t axis = 0; axis < Layout::dimension; ++axis)
    lanes.packed[axis] = Real(std::bit_cast<float>(1 << 29));
  for (std::size_t g = 0; g < list.count; ++g) {
    for (Real& number : lanes.packed) parts::touch(number);
    use();
  }
}

namespace parts {
namespace {

using Lane = Simd<float, NeighbourList::lanes(3)>;
using Fluid = LiquidScheme<3>::Fluid;

void sweep(benchmark::State& run, int dimension, Flavour flavour, SchemeName scheme) {
  State state = dam_break_state(dimension, flavour, scheme);
  for (auto _ : run) state.pairs->sweep(state.model.particles, state.search);
  run.counters["pairs"] = per_second(static_cast<double>(state.pairs->count_pairs(state.search)));
  run.counters["listed"] =
      per_second(listed(state.search.fluid_fluid()) + listed(state.search.fluid_wall()));
}

void gather_fluid(benchmark::State& run, SchemeName scheme) {
  State state = dam_break_state(3, Flavour::mixed, scheme);
  for (auto _ : run) state.pairs->gather_fluid(state.model.particles, state.search, 1e-5);
  run.counters["particles"] = per_second(static_cast<double>(state.fluid()));
}

void gather_walls(benchmark::State& run) {
  State state = dam_break_state(3);
  for (auto _ : run)
    state.pairs->gather_walls(state.model.particles, state.search, state.model.walls);
  run.counters["walls"] =
      per_second(static_cast<double>(state.model.particles.range(Kind::wall).size()));
}

/// Neighbours turned into lanes and thrown away. Range: particles of a periodic block per edge.
void loads_alone(benchmark::State& run) {
  State state(build_model(periodic_block(3, static_cast<int>(run.range(0)), Precision::mixed)),
              Flavour::mixed, SchemeName::liquid);
  std::size_t const points = state.fluid() + state.search.images(Kind::fluid).size();
  AlignedVector<float> const records(slots_for(points) * Fluid::stride, 1.0f);
  NeighbourList const& lists = state.search.fluid_fluid();
  Lanes<Lane, Fluid> lanes;
  for (auto _ : run)
    for (std::size_t i = 0; i < lists.size(); ++i)
      for_each_lanes(
          lists.of(i), records.data(), lanes, [&]() __attribute__((always_inline)) {
            for (Lane& number : lanes.packed) touch(number);
          });
  run.counters["listed"] = per_second(listed(lists));
}

/// The sweep of one particle on neighbours that are already in lanes.
void arithmetic_alone(benchmark::State& run) {
  SweepParameters parameters =
      sweep_parameters(build_model(periodic_block(3, 8, Precision::mixed)));
  parameters.position_scale = 1e-9;
  auto const uniform = parameters.uniform_as<float>();
  SweepConstants<Lane, 3, WendlandC2<3>> const constants(parameters);
  auto const terms = fluid_terms<Lane, 3>(parameters);
  alignas(64) float const record[Fluid::stride] = {};
  Broadcast<Lane, Resident<Fluid>> const self{record, uniform.data()};
  constexpr std::size_t groups = 11;  // 176 neighbours
  for (auto _ : run) {
    PairSum<Lane, 3> sum{};
    sum_over_pairs<false, Lane, 3, WendlandC2<3>, Resident<Fluid>>(
        constants, self, NeighbourGroups{nullptr, nullptr, groups}, nullptr, terms, sum);
    benchmark::DoNotOptimize(sum);
  }
  run.counters["listed"] = per_second(static_cast<double>(groups * Lane::size()));
}

bool const registered = [] {
  struct {
    char const* name;
    Flavour flavour;
  } const flavours[] = {{"mixed", Flavour::mixed}, {"double", Flavour::full}};
  struct {
    char const* name;
    SchemeName scheme;
  } const schemes[] = {{"liquid", SchemeName::liquid}, {"compressible", SchemeName::compressible}};
  for (int const dimension : {2, 3}) {
    std::string const start = "sweep/" + std::to_string(dimension) + "d/";
    for (auto const& flavour : flavours)
      for (auto const& scheme : schemes)
        benchmark::RegisterBenchmark((start + flavour.name + "/" + scheme.name).c_str(), sweep,
                                     dimension, flavour.flavour, scheme.scheme);
    benchmark::RegisterBenchmark((start + "reference").c_str(), sweep, dimension,
                                 Flavour::reference, SchemeName::compressible);
  }
  return true;
}();

BENCHMARK(loads_alone)->Arg(8)->Arg(24)->Arg(48);
BENCHMARK(arithmetic_alone);
BENCHMARK_CAPTURE(gather_fluid, liquid, SchemeName::liquid);
BENCHMARK_CAPTURE(gather_fluid, compressible, SchemeName::compressible);
BENCHMARK(gather_walls);

}  // namespace
}  // namespace parts
}  // namespace moraine
