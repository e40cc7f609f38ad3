// Points and vectors of three components; in 1D and 2D those beyond the dimension are zero.
#pragma once

#include <array>
#include <cmath>

namespace moraine {

using Vec3 = std::array<double, 3>;

inline Vec3 add(Vec3 const& a, Vec3 const& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

inline Vec3 subtract(Vec3 const& a, Vec3 const& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vec3 scale(double factor, Vec3 const& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

inline double dot(Vec3 const& a, Vec3 const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vec3 cross(Vec3 const& a, Vec3 const& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(Vec3 const& a) { return std::sqrt(dot(a, a)); }

}  // namespace moraine
