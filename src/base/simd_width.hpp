// How wide the registers of this build are; without what the instructions need.
#pragma once

#include <cstddef>

namespace moraine {

/// Lanes of the widest registers of this build, for 4-byte numbers.
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__)
#define MORAINE_AVX512 1
inline constexpr std::size_t widest_float = 16;
inline constexpr char const* simd_flavour = "AVX-512";
#elif defined(__AVX2__)
inline constexpr std::size_t widest_float = 8;
inline constexpr char const* simd_flavour = "AVX2";
#else
inline constexpr std::size_t widest_float = 4;
inline constexpr char const* simd_flavour = "SSE2";
#endif

}  // namespace moraine
