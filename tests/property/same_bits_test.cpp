// The number of threads changes no bit of a result.
#include <gtest/gtest.h>
#include <omp.h>

#include <bit>
#include <cstdint>
#include <vector>

#include "support/small_models.hpp"

namespace moraine {
namespace {

std::vector<std::uint64_t> bits_after(int steps, int dimension, Precision precision, int threads) {
  int const before = omp_get_max_threads();
  omp_set_num_threads(threads);
  Simulation simulation(small_dam_break(dimension, precision, 1.0));
  for (int step = 0; step < steps; ++step) simulation.advance();
  omp_set_num_threads(before);
  std::vector<std::uint64_t> bits{std::bit_cast<std::uint64_t>(simulation.time())};
  for (double const value : state_by_id(simulation.particles()))
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  for (double const value : simulation.sums().wall_impulse)
    bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

TEST(SameBits, ForAnyNumberOfThreads) {
  for (int const dimension : {2, 3})
    for (Precision const precision : {Precision::mixed, Precision::full}) {
      int const steps = dimension == 2 ? 60 : 20;
      auto const one = bits_after(steps, dimension, precision, 1);
      for (int const threads : {2, 3, 7})
        EXPECT_TRUE(bits_after(steps, dimension, precision, threads) == one)
            << dimension << "D, " << threads << " threads";
    }
}

}  // namespace
}  // namespace moraine
