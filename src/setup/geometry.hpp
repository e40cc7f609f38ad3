// Shapes of a case: what they contain and how far they reach.
#pragma once

#include <optional>

#include "setup/case.hpp"

namespace moraine {

/// Euclidean length of a vector.
double length(Point const& vector);

/// Inside, half-open: a point on a lower face belongs to the box, one on an upper face does not, so
/// that a point belongs to exactly one of two boxes that touch. Points closer to a face than
/// `tolerance` [m] count as on it.
bool contains(Box const& box, Point const& point, int dimension, double tolerance);

/// The same for any shape. Discs and half-planes own their whole boundary.
bool contains(Shape const& shape, Point const& point, int dimension, double tolerance);

/// Whether `inner` lies in `outer`, touching included, up to 1e-9 of the size of `outer`.
bool is_inside(Box const& inner, Box const& outer, int dimension);

/// The smallest box around a shape; nothing for a half-plane.
std::optional<Box> bounding_box(Shape const& shape, int dimension);

/// The box around all regions; nothing if there is none, or a half-plane among them.
std::optional<Box> box_around_regions(Case const& c);

/// The box around all walls and bounded regions, enlarged by its own extent on both sides of every
/// axis that is not periodic; nothing without a container wall or a bounded region.
std::optional<Box> default_domain(Case const& c);

}  // namespace moraine
