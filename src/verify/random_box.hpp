// A periodic box full of disorder: nothing in it is symmetric, so that conservation is no accident.
#pragma once

#include <cstdint>

#include "step/model.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

/// Particles about the points of a lattice in a box with periodic sides, at random velocities.
struct RandomBox {
  int dimension = 2;
  int side = 16;  // particles along each edge
  /// Two liquids, 1000 and 3000 kg/m^3, or one; smoothing lengths of random size with `variable`.
  SchemeName scheme = SchemeName::compressible;
  Precision precision = Precision::full;
  double displacement = 0.2;  // spacings, largest along each axis
  double velocity = 0.05;     // sound speeds, largest along each axis
  std::uint64_t seed = 1;
};

/// Spacing 1 cm, sound speeds 100 m/s, default numerics. The denser liquid fills the upper half
/// along x. Runs to time `end` [s]; the same numbers on every machine.
Model random_box(RandomBox const& box, double end);

}  // namespace moraine
