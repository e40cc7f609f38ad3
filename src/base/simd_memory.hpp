// SIMD numbers from and to memory.
//
// The two operations that decide the speed of the pair loops are `load_transposed` (rows of records
// to columns of lanes) and `compress_store` (append the selected lanes). Both have AVX-512, AVX2
// and portable forms here and nowhere else.
#pragma once

#include "base/simd.hpp"

namespace moraine {

// --- Records to lanes ---------------------------------------------------------------------------

namespace detail {

/// Rows k, k + 4, k + 8, ... of quads side by side: lane group g holds quad `from[g]`.
template <class T, std::size_t W>
struct QuadRows;

#if defined(__AVX2__)
template <>
struct QuadRows<float, 8> {
  MORAINE_FORMULA static __m256 join(float const* const* from, std::size_t offset) {
    __m256 const low = _mm256_castps128_ps256(_mm_load_ps(from[0] + offset));
    return _mm256_insertf128_ps(low, _mm_load_ps(from[1] + offset), 1);
  }
  MORAINE_FORMULA static void transpose(__m256 const (&r)[4], Simd<float, 8>* out) {
    __m256 const a = _mm256_unpacklo_ps(r[0], r[1]), b = _mm256_unpackhi_ps(r[0], r[1]);
    __m256 const c = _mm256_unpacklo_ps(r[2], r[3]), d = _mm256_unpackhi_ps(r[2], r[3]);
    out[0] = _mm256_shuffle_ps(a, c, 0x44);
    out[1] = _mm256_shuffle_ps(a, c, 0xEE);
    out[2] = _mm256_shuffle_ps(b, d, 0x44);
    out[3] = _mm256_shuffle_ps(b, d, 0xEE);
  }
};

template <>
struct QuadRows<double, 4> {
  MORAINE_FORMULA static __m256d join(double const* const* from, std::size_t offset) {
    return _mm256_load_pd(from[0] + offset);
  }
  MORAINE_FORMULA static void transpose(__m256d const (&r)[4], Simd<double, 4>* out) {
    __m256d const a = _mm256_unpacklo_pd(r[0], r[1]), b = _mm256_unpackhi_pd(r[0], r[1]);
    __m256d const c = _mm256_unpacklo_pd(r[2], r[3]), d = _mm256_unpackhi_pd(r[2], r[3]);
    out[0] = _mm256_permute2f128_pd(a, c, 0x20);
    out[1] = _mm256_permute2f128_pd(b, d, 0x20);
    out[2] = _mm256_permute2f128_pd(a, c, 0x31);
    out[3] = _mm256_permute2f128_pd(b, d, 0x31);
  }
};
#endif

#if defined(MORAINE_AVX512)
template <>
struct QuadRows<float, 16> {
  MORAINE_FORMULA static __m512 join(float const* const* from, std::size_t offset) {
    __m512 r = _mm512_castps128_ps512(_mm_load_ps(from[0] + offset));
    r = _mm512_insertf32x4(r, _mm_load_ps(from[1] + offset), 1);
    r = _mm512_insertf32x4(r, _mm_load_ps(from[2] + offset), 2);
    return _mm512_insertf32x4(r, _mm_load_ps(from[3] + offset), 3);
  }
  MORAINE_FORMULA static void transpose(__m512 const (&r)[4], Simd<float, 16>* out) {
    __m512d const a = _mm512_castps_pd(_mm512_unpacklo_ps(r[0], r[1]));
    __m512d const b = _mm512_castps_pd(_mm512_unpackhi_ps(r[0], r[1]));
    __m512d const c = _mm512_castps_pd(_mm512_unpacklo_ps(r[2], r[3]));
    __m512d const d = _mm512_castps_pd(_mm512_unpackhi_ps(r[2], r[3]));
    out[0] = _mm512_castpd_ps(_mm512_unpacklo_pd(a, c));
    out[1] = _mm512_castpd_ps(_mm512_unpackhi_pd(a, c));
    out[2] = _mm512_castpd_ps(_mm512_unpacklo_pd(b, d));
    out[3] = _mm512_castpd_ps(_mm512_unpackhi_pd(b, d));
  }
};

template <>
struct QuadRows<double, 8> {
  MORAINE_FORMULA static __m512d join(double const* const* from, std::size_t offset) {
    __m512d const low = _mm512_castpd256_pd512(_mm256_load_pd(from[0] + offset));
    return _mm512_insertf64x4(low, _mm256_load_pd(from[1] + offset), 1);
  }
  MORAINE_FORMULA static void transpose(__m512d const (&r)[4], Simd<double, 8>* out) {
    __m512d const a = _mm512_unpacklo_pd(r[0], r[1]), b = _mm512_unpackhi_pd(r[0], r[1]);
    __m512d const c = _mm512_unpacklo_pd(r[2], r[3]), d = _mm512_unpackhi_pd(r[2], r[3]);
    __m512i const even = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
    __m512i const odd = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
    out[0] = _mm512_permutex2var_pd(a, even, c);
    out[1] = _mm512_permutex2var_pd(b, even, d);
    out[2] = _mm512_permutex2var_pd(a, odd, c);
    out[3] = _mm512_permutex2var_pd(b, odd, d);
  }
};
#endif

template <class T, std::size_t W>
concept HasQuadRows = requires {
  sizeof(QuadRows<T, W>);
};

}  // namespace detail

/// Reads the record at base + offset[lane] * stride of every lane and returns it transposed:
/// out[k] lane l = base[offset[l] * stride + k] for k < 4 * quads.
///
/// A quad is four numbers; records are aligned to quads. Sixteen lanes cost sixteen 16-byte loads
/// and eight shuffles a quad, which on Zen 4 is 2.4 times cheaper than four hardware gathers
/// (docs/decisions/0001-one-list-no-cells.md). All quads of four records are read together, so that
/// an address is formed once.
template <int quads, class T, std::size_t W>
MORAINE_FORMULA void load_transposed(T const* base, std::size_t stride, std::uint16_t const* offset,
                                     Simd<T, W>* out) {
  if constexpr (detail::HasQuadRows<T, W>) {
    using Rows = detail::QuadRows<T, W>;
    decltype(Rows::join(nullptr, 0)) rows[quads][4];
    for (std::size_t k = 0; k < 4; ++k) {
      T const* from[W / 4];
      for (std::size_t g = 0; g < W / 4; ++g) from[g] = base + offset[k + 4 * g] * stride;
      for (std::size_t q = 0; q < quads; ++q) rows[q][k] = Rows::join(from, 4 * q);
    }
    for (std::size_t q = 0; q < quads; ++q) Rows::transpose(rows[q], out + 4 * q);
  } else {
    T columns[4 * quads][W];
    for (std::size_t lane = 0; lane < W; ++lane)
      for (std::size_t k = 0; k < 4 * quads; ++k)
        columns[k][lane] = base[offset[lane] * stride + k];
    for (std::size_t k = 0; k < 4 * quads; ++k) out[k] = Simd<T, W>::load(columns[k]);
  }
}

// --- Copying short rows
// ---------------------------------------------------------------------------

/// Copies `count` 4-byte values in whole vectors: up to 15 values more are read and written, which
/// both arrays must have room for. Several times faster than memmove for a few dozen values.
template <class T>
MORAINE_FORMULA void copy_in_vectors(T const* from, std::size_t count, T* to) {
  static_assert(sizeof(T) == 4);
  using Words = Simd<std::int32_t, widest_float>;
  for (std::size_t k = 0; k < count; k += widest_float) {
    Words words;
    std::memcpy(&words.v, from + k, sizeof words.v);
    std::memcpy(to + k, &words.v, sizeof words.v);
  }
}

// --- Appending selected lanes -------------------------------------------------------------------

/// Writes the lanes of `values` with mask set one after the other to `out` and returns how many.
/// `out` must have room for all W lanes: those beyond the count are scratch.
template <std::size_t W>
MORAINE_FORMULA int compress_store(std::uint32_t* out, std::uint32_t const* values, unsigned mask) {
#if defined(MORAINE_AVX512)
  // Compress in a register, then a plain store: the compressing store itself is microcode on Zen 4.
  if constexpr (W == 16) {
    __m512i const v = _mm512_loadu_si512(values);
    _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(static_cast<__mmask16>(mask), v));
    return __builtin_popcount(mask);
  } else if constexpr (W == 8) {
    __m256i const v = _mm256_loadu_si256(reinterpret_cast<__m256i const*>(values));
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(out),
                        _mm256_maskz_compress_epi32(static_cast<__mmask8>(mask), v));
    return __builtin_popcount(mask);
  }
#endif
  int count = 0;
  for (unsigned rest = mask; rest != 0; rest &= rest - 1)
    out[count++] = values[__builtin_ctz(rest)];
  return count;
}

/// Bit k of the result is set where a < b.
template <std::size_t W>
MORAINE_FORMULA unsigned bits_less(Simd<float, W> a, Simd<float, W> b) {
#if defined(MORAINE_AVX512)
  if constexpr (W == 16) return _mm512_cmp_ps_mask(a.v, b.v, _CMP_LT_OQ);
#endif
#if defined(__AVX2__)
  if constexpr (W == 8)
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)));
#endif
  if constexpr (W == 4) return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(a.v, b.v)));
}

/// Bit k of the result is set where values[k] == value.
template <std::size_t W>
MORAINE_FORMULA unsigned bits_equal(std::uint32_t const* values, std::uint32_t value) {
  auto const other = Simd<std::int32_t, W>(static_cast<std::int32_t>(value));
  auto const equal =
      Simd<std::int32_t, W>::load(reinterpret_cast<std::int32_t const*>(values)) == other;
#if defined(MORAINE_AVX512)
  if constexpr (W == 16) return _mm512_movepi32_mask((__m512i)equal);
#endif
#if defined(__AVX2__)
  if constexpr (W == 8) return static_cast<unsigned>(_mm256_movemask_ps((__m256)equal));
#endif
  if constexpr (W == 4) return static_cast<unsigned>(_mm_movemask_ps((__m128)equal));
}

}  // namespace moraine
