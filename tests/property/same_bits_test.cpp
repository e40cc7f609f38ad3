// The number of threads changes no bit of a result.
//
// Loops are cut into blocks (base/parallel_for.hpp): the models are large enough for more blocks
// than threads, and run through several rebuilds of the lists.
#include <gtest/gtest.h>
#include <omp.h>

#include <bit>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "base/parallel_for.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

constexpr int most_threads = 7;

struct Flow {
  std::string name;
  Model (*make)(Precision);
  int steps;
};

void PrintTo(Flow const& flow, std::ostream* stream) { *stream << flow.name; }

Model stirred_dam_break(int dimension, Precision precision, double spacing) {
  Model model = small_dam_break(dimension, precision, 1.0, spacing);
  stir(model, 2.0);
  return model;
}

Flow const flows[] = {
    {"dam_break_2d", [](Precision p) { return stirred_dam_break(2, p, 0.00195); }, 24},
    {"dam_break_3d", [](Precision p) { return stirred_dam_break(3, p, 0.0125); }, 16},
    {"blast_1d_mass",
     [](Precision p) { return blast_in_periodic_water(1, 30000, p, ContinuityForm::mass); }, 60},
    {"blast_2d_mass",
     [](Precision p) { return blast_in_periodic_water(2, 174, p, ContinuityForm::mass); }, 40},
    {"blast_2d_volume",
     [](Precision p) { return blast_in_periodic_water(2, 104, p, ContinuityForm::volume); }, 60},
    {"blast_3d_volume",
     [](Precision p) { return blast_in_periodic_water(3, 23, p, ContinuityForm::volume); }, 30},
    {"dam_break_2d_options",
     [](Precision p) { return with_options(stirred_dam_break(2, p, 0.0032)); }, 30},
    {"blast_2d_solid",
     [](Precision p) {
       return with_strength(blast_in_periodic_water(2, 104, p, ContinuityForm::mass));
     },
     40},
    {"dam_break_2d_summed",
     [](Precision p) { return with_summed_density(stirred_dam_break(2, p, 0.0032)); }, 30},
    {"blast_2d_options",
     [](Precision p) {
       return with_options(blast_in_periodic_water(2, 104, p, ContinuityForm::volume));
     },
     60},
};

struct Outcome {
  std::vector<std::uint64_t> bits;  // of the whole state, the time and the sums
  std::uint64_t rebuilds;
  std::size_t particles;
};

Outcome outcome_of(Flow const& flow, Precision precision, int threads) {
  int const before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Simulation simulation(flow.make(precision));
  std::vector<double> values;
  for (int step = 0; step < flow.steps; ++step) {
    simulation.advance();
    values.push_back(simulation.time());
    values.push_back(static_cast<double>(simulation.vote().particle));
  }
  ConservedSums const sums = simulation.sums();
  omp_set_num_threads(before);
  for (double const value : state_by_id(simulation.particles())) values.push_back(value);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    values.push_back(sums.wall_impulse[axis]);
    values.push_back(sums.momentum[axis]);
  }
  values.insert(values.end(), {sums.mass, sums.kinetic_energy, sums.internal_energy});
  Outcome result{
      {}, simulation.search().rebuilds(), simulation.particles().range(Kind::fluid).size()};
  for (double const value : values) result.bits.push_back(std::bit_cast<std::uint64_t>(value));
  return result;
}

/// Threads that a parallel loop really gets.
int threads_given(int wanted) {
  int const before = omp_get_max_threads();
  omp_set_num_threads(wanted);
  int given = 0;
#pragma omp parallel
#pragma omp single
  given = omp_get_num_threads();
  omp_set_num_threads(before);
  return given;
}

class SameBits : public testing::TestWithParam<std::tuple<Flow, Precision>> {};

TEST_P(SameBits, ForAnyNumberOfThreads) {
  auto const& [flow, precision] = GetParam();
  Outcome const one = outcome_of(flow, precision, 1);
  ASSERT_GE(one.particles, 10000u);
  ASSERT_GT(one.particles, 1024u * most_threads) << "more blocks than threads in every sum";
  EXPECT_GE(one.rebuilds, 4u) << "the first lists and three more";
  for (int const threads : {2, 3, most_threads}) {
    ASSERT_EQ(threads_given(threads), threads);
    Outcome const other = outcome_of(flow, precision, threads);
    EXPECT_EQ(other.rebuilds, one.rebuilds) << threads << " threads";
    EXPECT_TRUE(other.bits == one.bits) << threads << " threads";
  }
}

// The cheap loops have the longest blocks: some models are large enough for those too.
TEST(SameBitsModels, FillTheLongestBlocks) {
  int large = 0;
  for (Flow const& flow : flows) {
    Model const model = flow.make(Precision::full);
    if (model.particles.range(Kind::fluid).size() > loop_block * most_threads) ++large;
  }
  EXPECT_GE(large, 3);
}

std::string name_of(testing::TestParamInfo<std::tuple<Flow, Precision>> const& info) {
  return std::get<Flow>(info.param).name +
         (std::get<Precision>(info.param) == Precision::mixed ? "_mixed" : "_double");
}

INSTANTIATE_TEST_SUITE_P(All, SameBits,
                         testing::Combine(testing::ValuesIn(flows),
                                          testing::Values(Precision::mixed, Precision::full)),
                         name_of);

}  // namespace
}  // namespace moraine
