// What no sound run reaches: bounds of the guards, from the state that a run starts with.
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "step/model.hpp"

namespace moraine {

/// What a run starts with: the widest of the states at its start and at the start of each stage.
struct StateRange {
  std::vector<double> density_min, density_max;  // kg/m^3, by material; with the reference density
  double energy_min = 0.0, energy_max = 0.0;     // J/kg
  double signal_speed = 0.0;                     // m/s, largest |v| + c
  double lowest_potential = 0.0;                 // J/kg, least -g . x of a particle at the start

  /// Widens the range by the present state; sound speeds must be those of the state.
  void include(Model const& model);
  void exchange(Archive& archive);

 private:
  bool any_ = false;  // something has been included
};

/// Speed [m/s] of a fall through the domain, or for the whole run along a periodic axis.
double fall_speed(Model const& model);

/// Largest density by the densest at the start that the law of a material can be asked for.
double largest_compression(Eos const& eos);

/// Thinnest density at the start by the least: a thousand times what one smoothing length can
/// follow. Particles that have moved apart by a kernel support have no neighbours, and their
/// density stays.
double largest_expansion(Model const& model);

/// Bounds of the guards.
struct GuardBounds {
  std::vector<double> density_min, density_max;  // kg/m^3, by material
  double speed = 0.0;                            // m/s
  double energy_min = 0.0, energy_max = 0.0;     // J/kg
  double time_step = 0.0;                        // s
  double wall_depth = 0.0;                       // m
};

GuardBounds bounds_of(Model const& model, StateRange const& start);

}  // namespace moraine
