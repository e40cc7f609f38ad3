// Small 3 x 3 matrices: turning symmetric ones, and their principal values.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/symmetric.hpp"

namespace moraine {

/// Rows of a 3 x 3 matrix.
using Matrix3 = std::array<std::array<double, 3>, 3>;

MORAINE_HD inline Matrix3 full(Symmetric<3> const& m) {
  return {{{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}}};
}

/// R m R^T.
MORAINE_HD inline Symmetric<3> turned(Symmetric<3> const& m, Matrix3 const& r) {
  Matrix3 const a = full(m);
  Matrix3 half{};  // R m
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      half[i][j] = r[i][0] * a[0][j] + r[i][1] * a[1][j] + r[i][2] * a[2][j];
  Symmetric<3> result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      result[symmetric_index<3>(i, j)] =
          half[i][0] * r[j][0] + half[i][1] * r[j][1] + half[i][2] * r[j][2];
  return result;
}

/// The rotation about the axis `turn` by the angle |turn| [rad], after Rodrigues:
///
///   R = 1 + sin(a)/a W + (1 - cos(a))/a^2 W^2,   W x = turn cross x,   a = |turn|
///
/// exact for any angle.
MORAINE_HD inline Matrix3 rotation(std::array<double, 3> const& turn) {
  auto const [x, y, z] = turn;
  double const angle2 = x * x + y * y + z * z;
  double const angle = std::sqrt(angle2);
  bool const small = angle2 < 1e-8;  // the next terms of the series are below rounding
  double const a = small ? 1.0 - angle2 / 6.0 : std::sin(angle) / angle;
  double const half = std::sin(0.5 * angle);
  double const b = small ? 0.5 - angle2 / 24.0 : 2.0 * half * half / angle2;
  return {{{1.0 - b * (y * y + z * z), b * x * y - a * z, b * x * z + a * y},
           {b * x * y + a * z, 1.0 - b * (x * x + z * z), b * y * z - a * x},
           {b * x * z - a * y, b * y * z + a * x, 1.0 - b * (x * x + y * y)}}};
}

/// Principal values and the directions that belong to them.
struct Principal {
  std::array<double, 3> values{};
  Matrix3 directions{};  // columns, orthonormal: m = directions diag(values) directions^T
};

/// Of a symmetric matrix, values in descending order, by Jacobi's rotations: to rounding for any
/// matrix, equal values included. Source: Golub & Van Loan, Matrix Computations, section 8.5.
MORAINE_HD inline Principal principal(Symmetric<3> const& m) {
  Matrix3 a = full(m);
  Matrix3 q{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  constexpr std::size_t pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  constexpr int sweeps = 12;  // convergence is quadratic; 5 or 6 do
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double const off = std::fabs(a[0][1]) + std::fabs(a[0][2]) + std::fabs(a[1][2]);
    if (off == 0.0) break;
    for (auto const& [i, j] : pairs) {
      if (a[i][j] == 0.0) continue;
      double const theta = 0.5 * (a[j][j] - a[i][i]) / a[i][j];
      double const t =
          (theta < 0.0 ? -1.0 : 1.0) / (std::fabs(theta) + std::sqrt(theta * theta + 1.0));
      double const c = 1.0 / std::sqrt(t * t + 1.0);
      double const s = t * c;
      for (std::size_t k = 0; k < 3; ++k) {
        double const left = a[k][i], right = a[k][j];
        a[k][i] = c * left - s * right;
        a[k][j] = s * left + c * right;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        double const upper = a[i][k], lower = a[j][k];
        a[i][k] = c * upper - s * lower;
        a[j][k] = s * upper + c * lower;
        double const left = q[k][i], right = q[k][j];
        q[k][i] = c * left - s * right;
        q[k][j] = s * left + c * right;
      }
      a[i][j] = a[j][i] = 0.0;
    }
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  auto const sort = [&](std::size_t first, std::size_t second) {
    std::size_t const one = order[first], other = order[second];
    if (a[one][one] >= a[other][other]) return;
    order[first] = other;
    order[second] = one;
  };
  sort(0, 1);
  sort(1, 2);
  sort(0, 1);
  Principal result;
  for (std::size_t n = 0; n < 3; ++n) {
    result.values[n] = a[order[n]][order[n]];
    for (std::size_t k = 0; k < 3; ++k) result.directions[k][n] = q[k][order[n]];
  }
  return result;
}

/// The symmetric matrix with these principal values and directions.
MORAINE_HD inline Symmetric<3> from_principal(Principal const& p) {
  return turned({p.values[0], p.values[1], p.values[2], 0.0, 0.0, 0.0}, p.directions);
}

}  // namespace moraine
