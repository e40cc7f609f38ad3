// A step between two rebuilds of the neighbour lists allocates nothing.
#include <gtest/gtest.h>
#include <omp.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "support/small_models.hpp"

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  std::size_t const whole = (size + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, whole)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace moraine {
namespace {

TEST(Allocation, NoneInAStepThatKeepsItsLists) {
  for (Precision const precision : {Precision::mixed, Precision::full}) {
    Simulation simulation(small_dam_break(2, precision, 1.0));
    for (int step = 0; step < 50; ++step) simulation.advance();  // threads and buffers exist now
    int quiet = 0;
    for (int step = 0; step < 100; ++step) {
      auto const rebuilds = simulation.search().rebuilds();
      std::size_t const before = allocations;
      simulation.advance();
      std::size_t const after = allocations;
      if (simulation.search().rebuilds() != rebuilds) continue;
      EXPECT_EQ(after - before, 0u) << "step " << simulation.step();
      ++quiet;
    }
    EXPECT_GT(quiet, 10);
  }
}

// The counter itself works.
TEST(Allocation, IsCounted) {
  std::size_t const before = allocations;
  std::vector<double> const memory(100);
  EXPECT_GT(allocations, before) << memory.size();
}

}  // namespace
}  // namespace moraine
