// Mirror walls of a case: which sides of the domain they make.
#pragma once

#include <array>
#include <optional>

#include "search/side_images.hpp"
#include "setup/case.hpp"

namespace moraine {

/// A wall that is the side of the domain, by its number in Case::walls.
using MirrorSides = std::array<std::array<std::optional<std::size_t>, 2>, 3>;

/// The sides at which mirror walls stand: the closed sides of their boxes. Where several claim a
/// side it is that of the first.
MirrorSides mirror_sides(Case const& c);

/// Whether a side of the domain is a symmetry plane or a mirror wall.
bool is_plane(Case const& c, std::size_t axis, std::size_t end);

/// Planes of the model at the sides of the domain; `open` at symmetry planes too.
std::array<std::array<Plane, 2>, 3> mirror_planes(Case const& c);

/// Moves the sides of the domain to the mirror walls: beyond them there are images only.
void end_domain_at_mirrors(Case& c);

}  // namespace moraine
