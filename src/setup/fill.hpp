// Particles of a case on a lattice.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setup/case.hpp"
#include "setup/lattice.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// A particle before it is in the store.
struct Seed {
  Point position{};              // m
  Point velocity{};              // m/s
  double density = 0.0;          // kg/m^3
  double specific_energy = 0.0;  // J/kg
  double mass = 0.0;             // kg, per metre of thickness in 2D, per square metre in 1D
  MaterialId material = no_material;
  std::size_t region = 0;  // index in the case
};

/// What filling makes of a region.
struct RegionCount {
  std::size_t particles = 0;
  std::size_t replaced = 0;             // points that a later region took
  std::optional<MaterialId> stateless;  // a material that cannot have the pressure asked for
};

/// Fills the regions: points of the lattice of the case, by default corner + (k + 1/2) spacing, k
/// whole, in the order z, y, x with x running fastest. Of several regions around a point the last
/// one wins. Nothing is put outside the domain, inside solid walls, or, if there are container
/// walls, outside all of them (an open side bounds nothing). mass = density * volume of the lattice
/// per point, spacing^dimension for the square lattice; but there a Tait liquid with a hydrostatic
/// level, under gravity along an axis, has the mass of its reference density everywhere and layers
/// that lie the closer the deeper they are (setup/hydrostatic_layers.hpp). Points closer to a face
/// than 1e-6 spacings count as on it, so that rounding neither adds nor loses a row. Regions with a
/// lattice of their own (setup/region_lattice.hpp) follow after all others.
///
/// Throws InputErrors for every region without particles, and for every region whose pressure its
/// material cannot have.
std::vector<Seed> fill_regions(Case const& c);

/// How many particles each region gets and how many later regions take from it; no errors for
/// regions that get none, and no states are computed.
std::vector<RegionCount> count_regions(Case const& c);

/// About how many particles fill_regions makes of each region, at a cost that does not depend on
/// the spacing: the filled volume over that of a particle, with 4096 (1D), 128^2 or 40^3 samples in
/// the box around each region. Exact up to a layer of particles for boxes that nothing cuts,
/// otherwise within some per cent of a region's box.
std::vector<double> estimated_by_region(Case const& c);

/// The sum over all regions.
double estimated_particles(Case const& c);

}  // namespace moraine
