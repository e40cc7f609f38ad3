// The two SIMD operations that decide the speed, against what the processor offers for them.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <random>
#include <vector>

#include "base/aligned_vector.hpp"
#include "base/simd_memory.hpp"
#include "state.hpp"

namespace moraine::parts {
namespace {

using Lane = Simd<float, widest_float>;
constexpr std::size_t width = widest_float;
constexpr std::size_t stride = 8;  // numbers per record: two quads, as of one liquid in 3D

/// Records and ascending neighbours with gaps, as in a list; wrapped to `records` records.
struct Reads {
  explicit Reads(std::size_t records) : values(records * stride, 1.0f), offsets(32 * width) {
    std::mt19937 random(1);
    std::size_t at = 0;
    for (auto& offset : offsets) {
      at += 1 + random() % 4;
      offset = static_cast<std::uint16_t>(at % records);
    }
  }
  AlignedVector<float> values;
  std::vector<std::uint16_t> offsets;
};

void transposed_loads(benchmark::State& run) {
  Reads const reads(static_cast<std::size_t>(run.range(0)));
  for (auto _ : run)
    for (std::size_t k = 0; k < reads.offsets.size(); k += width) {
      Lane lanes[stride];
      load_transposed<2>(reads.values.data(), stride, reads.offsets.data() + k, lanes);
      benchmark::DoNotOptimize(lanes);
    }
  run.counters["records"] = per_second(static_cast<double>(reads.offsets.size()));
}
BENCHMARK(transposed_loads)->Arg(512)->Arg(16384);

#if defined(MORAINE_AVX512)
void hardware_gathers(benchmark::State& run) {
  Reads const reads(static_cast<std::size_t>(run.range(0)));
  for (auto _ : run)
    for (std::size_t k = 0; k < reads.offsets.size(); k += width) {
      Lane lanes[stride];
      __m512i const index = _mm512_slli_epi32(
          _mm512_cvtepu16_epi32(
              _mm256_loadu_si256(reinterpret_cast<__m256i const*>(reads.offsets.data() + k))),
          3);
      for (std::size_t n = 0; n < stride; ++n)
        lanes[n] = _mm512_i32gather_ps(index, reads.values.data() + n, 4);
      benchmark::DoNotOptimize(lanes);
    }
  run.counters["records"] = per_second(static_cast<double>(reads.offsets.size()));
}
BENCHMARK(hardware_gathers)->Arg(512)->Arg(16384);
#endif

/// Masks with about `run.range(0)` percent of the lanes set.
std::vector<unsigned> masks(std::int64_t percent) {
  std::mt19937 random(1);
  std::vector<unsigned> result(256);
  for (unsigned& mask : result)
    for (unsigned lane = 0; lane < width; ++lane)
      mask |= (random() % 100 < static_cast<unsigned>(percent) ? 1u : 0u) << lane;
  return result;
}

template <class Append>
void append(benchmark::State& run, Append&& append_lanes) {
  auto const wanted = masks(run.range(0));
  std::vector<std::uint32_t> const values(width, 7);
  std::vector<std::uint32_t> out(wanted.size() * width + width);
  for (auto _ : run) {
    std::uint32_t* to = out.data();
    for (unsigned const mask : wanted) to += append_lanes(to, values.data(), mask);
    benchmark::DoNotOptimize(to);
    benchmark::ClobberMemory();
  }
  run.counters["lanes"] = per_second(static_cast<double>(wanted.size() * width));
}

void compress_stores(benchmark::State& run) {
  append(run, [](std::uint32_t* to, std::uint32_t const* values, unsigned mask) {
    return compress_store<width>(to, values, mask);
  });
}
void scalar_appends(benchmark::State& run) {
  append(run, [](std::uint32_t* to, std::uint32_t const* values, unsigned mask) {
    int count = 0;
    for (unsigned lane = 0; lane < width; ++lane)
      if ((mask >> lane & 1u) != 0) to[count++] = values[lane];
    return count;
  });
}
BENCHMARK(compress_stores)->Arg(40);
BENCHMARK(scalar_appends)->Arg(40);

}  // namespace
}  // namespace moraine::parts
