// Symmetric D x D matrices as D (D + 1) / 2 numbers: the diagonal, then xy, xz, yz.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/macros.hpp"

namespace moraine {

template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

/// Where entry (a, b) is.
template <int D>
constexpr std::size_t symmetric_index(std::size_t a, std::size_t b) {
  return a == b ? a : static_cast<std::size_t>(D) + a + b - 1;
}

template <int D>
using Symmetric = std::array<double, static_cast<std::size_t>(symmetric_size<D>)>;

template <int D>
double trace(Symmetric<D> const& m) {
  double sum = 0.0;
  for (std::size_t a = 0; a < static_cast<std::size_t>(D); ++a) sum += m[a];
  return sum;
}

/// Determinant and adjugate: the inverse is adjugate / determinant.
template <int D>
struct Cofactors {
  double determinant = 0.0;
  Symmetric<D> adjugate{};
};

template <int D>
Cofactors<D> cofactors(Symmetric<D> const& m) {
  if constexpr (D == 1) {
    return {m[0], {1.0}};
  } else if constexpr (D == 2) {
    return {m[0] * m[1] - m[2] * m[2], {m[1], m[0], -m[2]}};
  } else {
    auto const& [xx, yy, zz, xy, xz, yz] = m;
    Symmetric<D> const adjugate{yy * zz - yz * yz, xx * zz - xz * xz, xx * yy - xy * xy,
                                xz * yz - xy * zz, xy * yz - xz * yy, xy * xz - xx * yz};
    return {xx * adjugate[0] + xy * adjugate[3] + xz * adjugate[4], adjugate};
  }
}

/// Square root of the sum of all D^2 squares.
template <int D>
double frobenius_norm(Symmetric<D> const& m) {
  double sum = 0.0;
  for (std::size_t k = 0; k < m.size(); ++k)
    sum += (k < static_cast<std::size_t>(D) ? 1.0 : 2.0) * m[k] * m[k];
  return std::sqrt(sum);
}

/// Component `axis` of matrix times vector, the matrix given by its numbers entry(k).
template <int D, class Real, class Entry>
MORAINE_FORMULA Real row_times(Entry const& entry, Real const (&x)[D], int axis) {
  Real sum = entry(static_cast<int>(symmetric_index<D>(static_cast<std::size_t>(axis), 0))) * x[0];
  for (int b = 1; b < D; ++b)
    sum += entry(static_cast<int>(
               symmetric_index<D>(static_cast<std::size_t>(axis), static_cast<std::size_t>(b)))) *
           x[b];
  return sum;
}

}  // namespace moraine
