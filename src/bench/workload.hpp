// What `moraine bench` runs: cases of known size, held in the program, or those of a file.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "setup/case.hpp"
#include "step/settings.hpp"

namespace moraine {

/// A case and how much of it is timed.
struct Workload {
  std::string_view name;
  std::string_view description;
  std::function<Case()> make;
  int warm_up = 100;   // steps before the clock starts
  int steps = 500;     // timed steps; 0: until the end of the case
  bool usual = false;  // part of `moraine bench` without names
};

/// All workloads, the usual ones first.
std::span<Workload const> workloads();

/// The case file `name`, which stays where it is, as a workload.
Workload workload_of_file(std::string_view name);

/// The workload of this name, if there is one; names that end with .toml are those of case files.
std::optional<Workload> find_workload(std::string_view name);

/// Water of 0.4 m x 0.67 m x 0.3 m (0.4 m x 0.3 m in 2D) at one end of a tank of 1.6 m, free from
/// the first step: the tank of the dam-break experiments that SPH codes are compared by. Lengths
/// are rounded down to whole spacings. Wendland C2 with about 163 neighbours in 3D (h = 1.732
/// spacings) and 20 in 2D (h = 1.262 spacings); Tait water of sound speed 33.675 m/s,
/// artificial viscosity 0.1, density diffusion 0.1, free-slip dummy walls, hydrostatic start.
Case dam_break(int dimension, double spacing, Precision precision);

/// The shipped case cases/tnt-in-water: 10 000 particles, two materials, 500 microseconds.
Case tnt_in_water();

/// The shipped case cases/surface-charge-6cm with h of 2 spacings and without gauges: 10 036
/// particles, one material with a strength, 500 microseconds.
Case charge_on_soil_2d();

/// A quarter of 12 x 12 x 6 cm of TNT on half a metre of loose sand in 3D, burnt at once: constant
/// h of 1.3 spacings, about 70 neighbours, all of the sand with a strength. spacing in m, 1 cm
/// makes 126 000 particles.
Case charge_on_soil(double spacing);

/// A periodic block of water at rest, `particles` long in every direction, spacing 1 m; kernel and
/// smoothing length as in dam_break. The smallest state with complete neighbourhoods.
Case periodic_block(int dimension, int particles, Precision precision);

}  // namespace moraine
