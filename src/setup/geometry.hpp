// How far the parts of a case reach.
#pragma once

#include <optional>

#include "setup/case.hpp"

namespace moraine {

/// Euclidean length of a vector.
double length(Point const& vector);

/// Whether `inner` lies in `outer`, touching included, up to 1e-9 of the size of `outer`.
bool is_inside(Box const& inner, Box const& outer, int dimension);

/// A box that has no end at symmetry planes and mirror walls: what lies beyond is cut off.
Box with_mirror_images(Box box, Case const& c);

/// What two boxes have in common; its max may lie below its min.
Box common(Box a, Box const& b);

/// The box around all regions; nothing if there is none, or one without bounds.
std::optional<Box> box_around_regions(Case const& c);

/// The box around all walls and bounded regions, enlarged by its own extent on both sides of every
/// axis that is not periodic; nothing without a container wall or a bounded region.
std::optional<Box> default_domain(Case const& c);

}  // namespace moraine
