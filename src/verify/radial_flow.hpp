// Flows about the origin: plane, cylinder and sphere, as halves, quarters and eighths.
#pragma once

#include <functional>

#include "exact/flow_geometry.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// The case, which is one of a single region in 1D, as the part of a plane slab, cylinder or ball
/// of this radius [m] that has no negative coordinate: the sides through the origin are symmetry
/// planes.
Case about_origin(Case c, FlowGeometry geometry, double radius);

/// Distance of a particle from the origin [m].
double distance_from_origin(ParticleStore const& store, std::size_t particle);

/// Mean of a field over the fluid with from <= r < to [m], weighted with volumes.
double mean_in_shell(Simulation const& simulation, Field field, double from, double to);

/// Where the mean pressure of shells of this width [m] falls below `level` [Pa] for good, between
/// the middles of two shells; 0 if it is below it everywhere.
double radius_of_pressure(Simulation const& simulation, double level, double width);

}  // namespace moraine
