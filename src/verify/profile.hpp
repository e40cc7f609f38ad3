// What checks read off a flow along x.
#pragma once

#include "step/simulation.hpp"

namespace moraine {

/// Mean of a field over the fluid with from <= x < to [m], weighted with volumes; not a number
/// where there is none.
double mean_between(Simulation const& simulation, Field field, double from, double to);

/// Farthest place along x where the pressure is above `least` [Pa], -infinity if it is nowhere.
double front_of_pressure(Simulation const& simulation, double least);

}  // namespace moraine
