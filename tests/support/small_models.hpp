// Small models that tests of the whole step start from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "step/simulation.hpp"
#include "verify/random_box.hpp"

namespace moraine {

/// A random box of 3D side 10, 2D side 24 or 1D side 200 in which the first axis ends at dummy
/// walls and the others repeat.
Model walled_random_box(RandomBox const& box, double end);

/// A column of Tait water (0.4 m x 0.3 m, in 3D 0.2 m deep) in a tank of 0.8 m. spacing in m.
Model small_dam_break(int dimension, Precision precision, double end, double spacing = 0.02);

/// A charge of TNT in the middle of a box of water, `side` particles of 1 cm along each edge, with
/// periodic sides.
Model blast_in_periodic_water(int dimension, int side, Precision precision,
                              ContinuityForm continuity);

/// The same model with all optional terms.
Model with_options(Model model);

/// The same model with density by normalised sums, and viscosity beside walls.
Model with_summed_density(Model model);

/// The same model with a strength in its first material: a soil that yields.
Model with_strength(Model model);

/// Adds velocities of up to `speed` [m/s] along each axis that differ from particle to particle.
void stir(Model& model, double speed);

/// All fields of all fluid particles in the order of their ids: the state, whatever the order in
/// memory.
std::vector<double> state_by_id(ParticleStore const& store);

/// Largest absolute value of a field component over the fluid.
double largest(ParticleStore const& store, Field field, int axis);

}  // namespace moraine
