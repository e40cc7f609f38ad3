// The height of a free surface along a line.
#pragma once

#include "base/vec3.hpp"
#include "search/search.hpp"
#include "smoothing/kernel_names.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// A straight line between two different points [m].
struct Line {
  Vec3 from{};
  Vec3 to{};
};

/// Where the fluid ends on a line, seen from its far end: the last place at which the share of the
/// kernel that is filled with fluid,
///
///   s(x) = sum_j (m_j / rho_j) W(x - x_j),
///
/// falls to half of its largest value on the line (of one, where that is larger). Returned is
/// x . u with u the direction of the line: the height of the surface for a line that goes straight
/// up. In front of a flat surface s is one half, by symmetry, whatever h is; near a wall, which the
/// kernel sum does not count, half of what it is in the depth. A lone particle in the open fills
/// too little to count (2D, smoothing factor 1.2: 0.39; less for larger factors and in 3D), and
/// water above holes counts: the highest surface is found.
///
/// Not a number where the largest s is below one tenth: no fluid on the line. The end of the line
/// where the fluid goes beyond it. The line is looked at in steps of h / 4: a gap thinner than that
/// may be overlooked. h in m.
double probe_level(ParticleStore const& store, Search const& search, KernelName kernel, double h,
                   Line const& line);

}  // namespace moraine
