#include "setup/shape/shape.hpp"

#include <algorithm>
#include <type_traits>

namespace moraine {

bool contains(Shape const& shape, Point const& point, int dimension, double tolerance) {
  return std::visit(
      [&](auto const& single) { return contains(single, point, dimension, tolerance); }, shape);
}

Box around(Box const& a, Box const& b) {
  Box result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.min[axis] = std::min(a.min[axis], b.min[axis]);
    result.max[axis] = std::max(a.max[axis], b.max[axis]);
  }
  return result;
}

std::optional<Box> bounding_box(Shape const& shape, int dimension) {
  return std::visit(
      [&](auto const& single) -> std::optional<Box> {
        using Single = std::remove_cvref_t<decltype(single)>;
        if constexpr (std::is_same_v<Single, HalfPlane>)
          return std::nullopt;
        else if constexpr (std::is_same_v<Single, Box>)
          return single;
        else
          return bounds(single, dimension);
      },
      shape);
}

}  // namespace moraine
