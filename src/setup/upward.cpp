#include "setup/upward.hpp"

namespace moraine {

std::optional<int> side_above(Case const& c, std::optional<int> const& given) {
  if (given) return given;
  std::optional<int> side;
  for (int axis = 0; axis < 3; ++axis) {
    double const pull = c.gravity[static_cast<std::size_t>(axis)];
    if (pull == 0.0) continue;
    if (side) return std::nullopt;
    side = 2 * axis + (pull < 0.0 ? 1 : 0);
  }
  return side ? side : 2 * (c.dimension - 1) + 1;
}

}  // namespace moraine
