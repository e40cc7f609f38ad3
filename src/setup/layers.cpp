#include "setup/layers.hpp"

namespace moraine {

std::optional<Upward> upward_of(Case const& c) {
  std::optional<Upward> upward;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (c.gravity[axis] == 0.0) continue;
    if (upward) return std::nullopt;
    upward = Upward{axis, c.gravity[axis] < 0.0 ? 1.0 : -1.0};
  }
  if (!upward && c.dimension > 0) upward = Upward{static_cast<std::size_t>(c.dimension - 1), 1.0};
  return upward;
}

double top_of_layers(RegionSpec const& region, Case const& c, Upward const& upward) {
  if (region.layers.top) return *region.layers.top;
  Box const box = *bounding_box_of_tree(region, c.dimension);
  return upward.height(upward.sign > 0.0 ? box.max : box.min);
}

std::optional<std::size_t> layer_at(Layers const& layers, double top, double height, double sign,
                                    double tolerance) {
  // A point on a face counts as just beyond it towards larger coordinates.
  double const depth = top - height - sign * tolerance;
  if (depth < 0.0) return std::nullopt;
  double bottom = 0.0;
  for (std::size_t i = 0; i < layers.thickness.size(); ++i) {
    bottom += layers.thickness[i];
    if (depth < bottom) return i;
  }
  bool const endless = layers.thickness.size() < layers.materials.size();
  return endless ? std::optional(layers.materials.size() - 1) : std::nullopt;
}

}  // namespace moraine
