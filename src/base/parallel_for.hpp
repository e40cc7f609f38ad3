// Loops over fixed blocks of indices, shared among threads.
//
// How a range is cut into blocks depends on its length alone, never on the number of threads, and
// partial results are combined in block order: results have the same bits for any thread count.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace moraine {

#if defined(_OPENMP)
inline std::size_t thread_count() { return static_cast<std::size_t>(omp_get_max_threads()); }
inline std::size_t thread_index() { return static_cast<std::size_t>(omp_get_thread_num()); }
#else
inline std::size_t thread_count() { return 1; }
inline std::size_t thread_index() { return 0; }
#endif

/// Calls f(begin, end) for consecutive blocks of at most `block` indices that cover [0, count).
template <class F>
void for_each_block(std::size_t count, std::size_t block, F&& f) {
  auto const blocks = static_cast<std::ptrdiff_t>((count + block - 1) / block);
#pragma omp parallel for schedule(dynamic) if (blocks > 1)
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    std::size_t const begin = static_cast<std::size_t>(b) * block;
    f(begin, std::min(begin + block, count));
  }
}

/// Indices per block for cheap loops over particles: long enough to hide the scheduling.
inline constexpr std::size_t loop_block = 4096;

/// Combines f(begin, end) of all blocks of [0, count) in order: ((init + f0) + f1) + ...
template <class T, class F, class Combine>
T reduce_blocks(std::size_t count, T init, F&& f, Combine&& combine) {
  constexpr std::size_t most_blocks = 256;
  std::size_t const block = std::max<std::size_t>(1024, (count + most_blocks - 1) / most_blocks);
  auto const blocks = static_cast<std::ptrdiff_t>((count + block - 1) / block);
  std::array<T, most_blocks> partial;
#pragma omp parallel for schedule(dynamic) if (blocks > 1)
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    std::size_t const begin = static_cast<std::size_t>(b) * block;
    partial[static_cast<std::size_t>(b)] = f(begin, std::min(begin + block, count));
  }
  for (std::ptrdiff_t b = 0; b < blocks; ++b)
    init = combine(init, partial[static_cast<std::size_t>(b)]);
  return init;
}

}  // namespace moraine
