#include "setup/shape/polygon.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace moraine {
namespace {

using Point2 = std::array<double, 2>;

// The axes of the plane that the corners lie in.
std::array<std::size_t, 2> plane_axes(Polygon const& polygon, int dimension) {
  if (dimension < 3 || polygon.axis == 2) return {0, 1};
  return polygon.axis == 0 ? std::array<std::size_t, 2>{1, 2} : std::array<std::size_t, 2>{0, 2};
}

// Twice the area of a triangle: positive to the left of a -> b.
double turn(Point2 const& a, Point2 const& b, Point2 const& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Whether c, on the line through a and b, lies between them.
bool between(Point2 const& a, Point2 const& b, Point2 const& c) {
  return std::min(a[0], b[0]) <= c[0] && c[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= c[1] && c[1] <= std::max(a[1], b[1]);
}

bool meet(Point2 const& a, Point2 const& b, Point2 const& c, Point2 const& d) {
  double const c_side = turn(a, b, c), d_side = turn(a, b, d);
  double const a_side = turn(c, d, a), b_side = turn(c, d, b);
  bool const crossing = ((c_side > 0.0 && d_side < 0.0) || (c_side < 0.0 && d_side > 0.0)) &&
                        ((a_side > 0.0 && b_side < 0.0) || (a_side < 0.0 && b_side > 0.0));
  return crossing || (c_side == 0.0 && between(a, b, c)) || (d_side == 0.0 && between(a, b, d)) ||
         (a_side == 0.0 && between(c, d, a)) || (b_side == 0.0 && between(c, d, b));
}

// Sides i and i + 1 lie on each other.
bool folds_back(Polygon const& polygon, std::size_t i) {
  Point2 const a = polygon.corner(i), b = polygon.corner(i + 1), c = polygon.corner(i + 2);
  double const back = (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]);
  return turn(a, b, c) == 0.0 && back > 0.0;
}

std::string place_of(Point2 const& a) { return fmt::format("({:.6g}, {:.6g})", a[0], a[1]); }

}  // namespace

bool contains(Polygon const& polygon, Point const& point, int dimension, double tolerance) {
  auto const axes = plane_axes(polygon, dimension);
  if (dimension == 3) {
    double const height = point[static_cast<std::size_t>(polygon.axis)];
    if (height < *polygon.from - tolerance || height >= *polygon.to - tolerance) return false;
  }
  // Moved off any side that it may lie on, never along an axis or a diagonal.
  double const x = point[axes[0]] + tolerance;
  double const y = point[axes[1]] + 0.7 * tolerance;
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Point2 const a = polygon.corner(i), b = polygon.corner(i + 1);
    if ((a[1] > y) == (b[1] > y)) continue;
    bool const left = (turn(a, b, {x, y}) > 0.0) == (b[1] > a[1]);  // of the side: the ray meets it
    inside = inside != left;
  }
  return inside;
}

Box bounds(Polygon const& polygon, int dimension) {
  auto const axes = plane_axes(polygon, dimension);
  Box box;
  for (std::size_t part = 0; part < 2; ++part) {
    double low = polygon.corners[part], high = low;
    for (std::size_t i = part; i < polygon.corners.size(); i += 2) {
      low = std::min(low, polygon.corners[i]);
      high = std::max(high, polygon.corners[i]);
    }
    box.min[axes[part]] = low;
    box.max[axes[part]] = high;
  }
  if (dimension == 3) {
    box.min[static_cast<std::size_t>(polygon.axis)] = *polygon.from;
    box.max[static_cast<std::size_t>(polygon.axis)] = *polygon.to;
  }
  return box;
}

double area(Polygon const& polygon) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += turn(polygon.corner(0), polygon.corner(i), polygon.corner(i + 1));
  return 0.5 * std::abs(twice);
}

std::string defect_of(Polygon const& polygon) {
  std::size_t const n = polygon.size();
  if (n < 3) return fmt::format("has {} corner{}; at least 3 are needed", n, n == 1 ? "" : "s");
  for (std::size_t i = 0; i < n; ++i) {
    if (polygon.corner(i) == polygon.corner(i + 1))
      return fmt::format("has corner {} twice in a row, at {}", i + 1, place_of(polygon.corner(i)));
    if (folds_back(polygon, i))
      return fmt::format("folds back onto itself at corner {}, {}", (i + 1) % n + 1,
                         place_of(polygon.corner(i + 1)));
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t const end = i == 0 ? n - 1 : n;  // neighbouring sides share a corner
    for (std::size_t j = i + 2; j < end; ++j)
      if (meet(polygon.corner(i), polygon.corner(i + 1), polygon.corner(j), polygon.corner(j + 1)))
        return fmt::format(
            "meets itself: the side from corner {} at {} and the side from corner "
            "{} at {}",
            i + 1, place_of(polygon.corner(i)), j + 1, place_of(polygon.corner(j)));
  }
  return {};
}

}  // namespace moraine
