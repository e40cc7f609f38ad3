// SIMD numbers: a thin class over the compiler's vector types.
//
// Formulas are written for a generic number type Real and use the free functions below, which also
// exist for plain float and double. How lanes get in and out of memory: base/simd_memory.hpp. Why
// not std::experimental::simd: docs/decisions/0002-simd.md.
#pragma once

#include <immintrin.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "base/macros.hpp"
#include "base/simd_width.hpp"

namespace moraine {

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
  /// Integers wrap around: places in fixed point do so across a periodic side, on purpose.
  MORAINE_FORMULA friend Simd operator-(Simd a, Simd b) {
    if constexpr (std::is_integral_v<T>) {
      using Unsigned = typename detail::VectorOf<std::make_unsigned_t<T>, W>::type;
      return (Vector)((Unsigned)a.v - (Unsigned)b.v);
    } else {
      return a.v - b.v;
    }
  }
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

}  // namespace moraine
