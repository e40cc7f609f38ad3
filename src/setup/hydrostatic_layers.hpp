// Layers of a liquid at rest: particles of equal mass, closer together where the pressure is
// higher.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "setup/fill.hpp"
#include "setup/lattice.hpp"

namespace moraine {

/// The lattice axis that gravity g [m/s^2] lies on and the sense of "up" along it.
struct Vertical {
  std::size_t axis;
  int up;  // +1 or -1
};

/// Nothing without gravity or where it is oblique to the lattice.
std::optional<Vertical> vertical_of(Point const& gravity);

/// Moves particles of a lattice down, so that each fills the height that its mass needs at its
/// density:
///
///   dz_k = m_k / (rho_k dx^(d-1)),   z_k = z_bottom + sum_(l<k) dz_l + dz_k / 2
///
/// Particles whose densities belong to p_k = rho_0 |g| (level - z0_k), z0_k the height on the even
/// lattice, and whose masses are set to rho_0 dx^d are then in equilibrium: from layer to layer the
/// pressure grows by the weight of a layer, |g| rho_0 dx per area. The lower face of the lowest
/// layer stays where it is.
///
/// That holds for columns that reach unbroken from one level floor to the free surface. Where a
/// body in the water, a step of the floor or a lid stands in the way, columns would sink by
/// different amounts and leave gaps; then nothing is changed, and particles keep their places and
/// the masses of their densities.
///
/// `seeds` are in the order of fill_regions; `layered` names those that take part, ascending, all
/// on the points of one square lattice.
void compress_layers(std::vector<Seed>& seeds, std::span<std::size_t const> layered, Case const& c,
                     Lattice const& lattice, Vertical vertical);

}  // namespace moraine
