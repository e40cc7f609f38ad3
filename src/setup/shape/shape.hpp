// Shapes and trees of shapes.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "setup/shape/box.hpp"
#include "setup/shape/cylinder.hpp"
#include "setup/shape/disc.hpp"
#include "setup/shape/half_plane.hpp"
#include "setup/shape/polygon.hpp"
#include "setup/shape/stl_body.hpp"

namespace moraine {

/// The closed list of shapes. Adding one: its header with `contains` and `bounds`, an entry here,
/// its keys in setup/shape_table.hpp, a test.
using Shape = std::variant<Box, Disc, HalfPlane, Cylinder, Polygon, StlBody>;

/// A shape with others added to it and others taken away: (shape or any of plus) and none of minus.
struct ShapeTree {
  Shape shape;
  std::vector<ShapeTree> plus{};
  std::vector<ShapeTree> minus{};
};

/// Whether a shape contains a point; see the single shapes about their boundaries.
bool contains(Shape const& shape, Point const& point, int dimension, double tolerance);

/// The same for anything with `shape`, `plus` and `minus`. What is taken away takes its own
/// boundary with it, so that the difference and what was taken away share no point.
template <class Tree>
bool contains_tree(Tree const& tree, Point const& point, int dimension, double tolerance) {
  bool inside = contains(tree.shape, point, dimension, tolerance);
  for (auto part = tree.plus.begin(); !inside && part != tree.plus.end(); ++part)
    inside = contains_tree(*part, point, dimension, tolerance);
  for (auto part = tree.minus.begin(); inside && part != tree.minus.end(); ++part)
    inside = !contains_tree(*part, point, dimension, tolerance);
  return inside;
}

/// The smallest box around both.
Box around(Box const& a, Box const& b);

/// The smallest box around a shape; nothing for a half-plane.
std::optional<Box> bounding_box(Shape const& shape, int dimension);

/// A box around anything with `shape`, `plus` and `minus`, as if nothing was taken away; nothing if
/// a part of it has no bounds.
template <class Tree>
std::optional<Box> bounding_box_of_tree(Tree const& tree, int dimension) {
  std::optional<Box> box = bounding_box(tree.shape, dimension);
  for (auto const& part : tree.plus) {
    auto const other = bounding_box_of_tree(part, dimension);
    box = box && other ? std::optional(around(*box, *other)) : std::nullopt;
  }
  return box;
}

}  // namespace moraine
