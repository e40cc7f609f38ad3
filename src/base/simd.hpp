// SIMD numbers: a thin class over the compiler's vector types, plus the operations they lack.
//
// Formulas are written for a generic number type Real and use the free functions below, which also
// exist for plain float and double. The two operations that decide the speed of the pair loops are
// `load_transposed` (rows of records to columns of lanes) and `compress_store` (append the selected
// lanes); both have AVX-512, AVX2 and portable forms here and nowhere else. Why not
// std::experimental::simd: docs/decisions/0002-simd.md.
#pragma once

#include <immintrin.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "base/macros.hpp"

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

namespace detail {
template <class T, std::size_t W>
struct VectorOf {
  typedef T type __attribute__((vector_size(W * sizeof(T))));
};
}  // namespace detail

/// A vector of W numbers of type T (float, double or std::int32_t).
template <class T, std::size_t W>
struct Simd {
  using value_type = T;
  using Vector = typename detail::VectorOf<T, W>::type;

  Vector v;

  Simd() = default;
  MORAINE_FORMULA Simd(Vector vector) : v(vector) {}
  /// The same number in all lanes. Subtracting zero is how vector types spell it; it costs nothing.
  MORAINE_FORMULA explicit Simd(T value) : v(value - Vector{}) {}
  static constexpr std::size_t size() { return W; }

  MORAINE_FORMULA static Simd load(T const* from) {
    Simd result;
    std::memcpy(&result.v, from, sizeof(Vector));
    return result;
  }
  MORAINE_FORMULA T operator[](std::size_t lane) const { return v[lane]; }

  MORAINE_FORMULA friend Simd operator+(Simd a, Simd b) { return a.v + b.v; }
  MORAINE_FORMULA friend Simd operator-(Simd a, Simd b) { return a.v - b.v; }
  MORAINE_FORMULA friend Simd operator*(Simd a, Simd b) { return a.v * b.v; }
  MORAINE_FORMULA friend Simd operator/(Simd a, Simd b) { return a.v / b.v; }
  MORAINE_FORMULA friend Simd operator-(Simd a) { return -a.v; }
  MORAINE_FORMULA Simd& operator+=(Simd b) { return *this = *this + b; }
  MORAINE_FORMULA Simd& operator-=(Simd b) { return *this = *this - b; }
  MORAINE_FORMULA Simd& operator*=(Simd b) { return *this = *this * b; }

  /// Comparisons give masks: vectors of integers, all bits set where true.
  MORAINE_FORMULA friend auto operator<(Simd a, Simd b) { return a.v < b.v; }
  MORAINE_FORMULA friend auto operator==(Simd a, Simd b) { return a.v == b.v; }
};

// --- Generic arithmetic: the same names for scalars and vectors -------------------------------

namespace detail {
template <class Real>
struct SlotOf {
  using type = Real;
};
template <class T, std::size_t W>
struct SlotOf<Simd<T, W>> {
  using type = T;
};
}  // namespace detail

/// float or double: what one lane of Real holds.
template <class Real>
using SlotOf = typename detail::SlotOf<Real>::type;

/// A constant of type Real in all lanes.
template <class Real>
MORAINE_FORMULA constexpr Real number(double value) {
  return Real(static_cast<SlotOf<Real>>(value));
}

MORAINE_FORMULA float maximum(float a, float b) { return a > b ? a : b; }
MORAINE_FORMULA double maximum(double a, double b) { return a > b ? a : b; }
MORAINE_FORMULA float minimum(float a, float b) { return a < b ? a : b; }
MORAINE_FORMULA double minimum(double a, double b) { return a < b ? a : b; }
MORAINE_FORMULA float square_root(float a) { return std::sqrt(a); }
MORAINE_FORMULA double square_root(double a) { return std::sqrt(a); }
MORAINE_FORMULA float select(bool mask, float yes, float no) { return mask ? yes : no; }
MORAINE_FORMULA double select(bool mask, double yes, double no) { return mask ? yes : no; }

MORAINE_FORMULA Simd<float, 4> maximum(Simd<float, 4> a, Simd<float, 4> b) {
  return _mm_max_ps(a.v, b.v);
}
MORAINE_FORMULA Simd<float, 4> minimum(Simd<float, 4> a, Simd<float, 4> b) {
  return _mm_min_ps(a.v, b.v);
}
MORAINE_FORMULA Simd<float, 4> square_root(Simd<float, 4> a) { return _mm_sqrt_ps(a.v); }
MORAINE_FORMULA Simd<double, 2> maximum(Simd<double, 2> a, Simd<double, 2> b) {
  return _mm_max_pd(a.v, b.v);
}
MORAINE_FORMULA Simd<double, 2> minimum(Simd<double, 2> a, Simd<double, 2> b) {
  return _mm_min_pd(a.v, b.v);
}
MORAINE_FORMULA Simd<double, 2> square_root(Simd<double, 2> a) { return _mm_sqrt_pd(a.v); }

#if defined(__AVX2__)
MORAINE_FORMULA Simd<float, 8> maximum(Simd<float, 8> a, Simd<float, 8> b) {
  return _mm256_max_ps(a.v, b.v);
}
MORAINE_FORMULA Simd<float, 8> minimum(Simd<float, 8> a, Simd<float, 8> b) {
  return _mm256_min_ps(a.v, b.v);
}
MORAINE_FORMULA Simd<float, 8> square_root(Simd<float, 8> a) { return _mm256_sqrt_ps(a.v); }
MORAINE_FORMULA Simd<double, 4> maximum(Simd<double, 4> a, Simd<double, 4> b) {
  return _mm256_max_pd(a.v, b.v);
}
MORAINE_FORMULA Simd<double, 4> minimum(Simd<double, 4> a, Simd<double, 4> b) {
  return _mm256_min_pd(a.v, b.v);
}
MORAINE_FORMULA Simd<double, 4> square_root(Simd<double, 4> a) { return _mm256_sqrt_pd(a.v); }
#endif

#if defined(MORAINE_AVX512)
MORAINE_FORMULA Simd<float, 16> maximum(Simd<float, 16> a, Simd<float, 16> b) {
  return _mm512_max_ps(a.v, b.v);
}
MORAINE_FORMULA Simd<float, 16> minimum(Simd<float, 16> a, Simd<float, 16> b) {
  return _mm512_min_ps(a.v, b.v);
}
MORAINE_FORMULA Simd<float, 16> square_root(Simd<float, 16> a) { return _mm512_sqrt_ps(a.v); }
MORAINE_FORMULA Simd<double, 8> maximum(Simd<double, 8> a, Simd<double, 8> b) {
  return _mm512_max_pd(a.v, b.v);
}
MORAINE_FORMULA Simd<double, 8> minimum(Simd<double, 8> a, Simd<double, 8> b) {
  return _mm512_min_pd(a.v, b.v);
}
MORAINE_FORMULA Simd<double, 8> square_root(Simd<double, 8> a) { return _mm512_sqrt_pd(a.v); }
#endif

template <class Mask, class T, std::size_t W>
MORAINE_FORMULA Simd<T, W> select(Mask mask, Simd<T, W> yes, Simd<T, W> no) {
  return mask ? yes.v : no.v;
}

/// Integers to floating point, lane by lane.
template <class T, std::size_t W>
MORAINE_FORMULA Simd<T, W> convert(Simd<std::int32_t, W> a) {
  return __builtin_convertvector(a.v, typename Simd<T, W>::Vector);
}

/// Sum and largest of the lanes, by halves: the order is fixed.
MORAINE_FORMULA double sum_of_lanes(double a) { return a; }
MORAINE_FORMULA double largest_lane(double a) { return a; }
template <class T, std::size_t W>
MORAINE_FORMULA T sum_of_lanes(Simd<T, W> a) {
  if constexpr (W == 1) {
    return a[0];
  } else if constexpr (sizeof(a.v) == 16) {
    T sum = a[0];
    for (std::size_t lane = 1; lane < W; ++lane) sum += a[lane];
    return sum;
  } else {
    struct Halves {
      Simd<T, W / 2> low, high;
    } const halves = __builtin_bit_cast(Halves, a.v);
    return sum_of_lanes(halves.low + halves.high);
  }
}
template <class T, std::size_t W>
MORAINE_FORMULA T largest_lane(Simd<T, W> a) {
  T largest = a[0];
  for (std::size_t lane = 1; lane < W; ++lane) largest = maximum(largest, a[lane]);
  return largest;
}

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
concept HasQuadRows = requires { sizeof(QuadRows<T, W>); };

}  // namespace detail

/// Reads the record at base + offset[lane] * stride of every lane and returns it transposed:
/// out[k] lane l = base[offset[l] * stride + k] for k < 4 * quads.
///
/// A quad is four numbers; records are aligned to quads. Sixteen lanes cost sixteen 16-byte loads
/// and eight shuffles a quad, which on Zen 4 is 2.4 times cheaper than four hardware gathers
/// (docs/decisions/0002-simd.md). All quads of four records are read together, so that an address is
/// formed once.
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
      for (std::size_t k = 0; k < 4 * quads; ++k) columns[k][lane] = base[offset[lane] * stride + k];
    for (std::size_t k = 0; k < 4 * quads; ++k) out[k] = Simd<T, W>::load(columns[k]);
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
