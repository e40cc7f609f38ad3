// Particles of a case on a lattice.
#pragma once

#include <vector>

#include "setup/case.hpp"
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

/// Corner of the lattice: the lower corner of the first container wall, or else of the first box
/// region, or else the origin. The domain plays no part, so that enlarging it moves no particle.
Point lattice_anchor(Case const& c);

/// Fills the regions: points anchor + (k + 1/2) spacing, k whole, in the order z, y, x with x
/// running fastest. Of several regions around a point the last one wins. Nothing is put outside
/// the domain, inside solid walls, or, if there are container walls, outside all of them (an open
/// side bounds nothing). mass = density * spacing^dimension, but a Tait liquid with a hydrostatic
/// level, under gravity along an axis, has the mass of its reference density everywhere and layers
/// that lie the closer the deeper they are (setup/hydrostatic_layers.hpp). Points closer to a face
/// than 1e-6 spacings count as on it, so that rounding neither adds nor loses a row.
///
/// Throws InputErrors for every region without particles, and for every region whose pressure its
/// material cannot have.
std::vector<Seed> fill_regions(Case const& c);

/// About how many particles fill_regions makes, at a cost that does not depend on the spacing: the
/// filled volume over that of a particle, with 4096 (1D), 128^2 or 40^3 samples in the box around
/// each region. Exact up to a layer of particles for boxes that nothing cuts, otherwise within some
/// per cent of a region's box.
double estimated_particles(Case const& c);

}  // namespace moraine
