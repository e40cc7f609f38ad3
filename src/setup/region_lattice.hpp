// The lattices that the regions of a case are filled on, each at its own spacing.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setup/case.hpp"
#include "setup/lattice.hpp"

namespace moraine {

/// Whether a region gives a spacing of its own, by length or by mass.
inline bool has_own_lattice(RegionSpec const& region) {
  return region.spacing.has_value() || !region.equal_mass_with.empty();
}

/// Density [kg/m^3] that the particles of a region of one material start with: solved for the
/// pressure where one is given. Where the pressure varies from place to place (hydrostatic,
/// lithostatic), and where the material cannot have it, the reference density.
double start_density(Case const& c, RegionSpec const& region);

/// The lattice of each region: that of the case, or its own.
///
/// With `equal_mass_with` region k, the volume of a particle and its spacing are
///
///   V = V_k rho_k / rho,   spacing = V^(1/d),   so that  rho V = rho_k V_k,
///
/// rho from start_density. An own lattice is centred in the box around its region, as far as the
/// domain and the first container reach: of a box, a disc or a ball it makes a symmetric body, and
/// where the box is a whole number of layers long its first layer lies half a layer from the face.
/// Along gravity it stands on the lower face, and in a periodic domain that it fills it starts at
/// the seam. A hexagonal lattice is fitted to that box like the one of the case, unless its masses
/// are given. Without a box around the region the corner is that of the case.
///
/// Throws std::invalid_argument for a region that `equal_mass_with` does not name, or that leads
/// back to itself; `check_spacings` tells users so before.
std::vector<Lattice> lattices_of_regions(Case const& c);

/// The smallest spacing of the case's regions and of the case itself [m].
double finest_spacing(Case const& c);

/// The box around a region, as far as the domain and the first container reach.
std::optional<Box> filled_box(Case const& c, RegionSpec const& region);

/// Whether a region reaches through the whole domain along a periodic axis.
bool fills_period(Case const& c, RegionSpec const& region, std::size_t axis);

}  // namespace moraine
