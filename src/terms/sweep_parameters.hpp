#pragma once

#include <array>

#include "smoothing/kernel_names.hpp"
#include "terms/record_layout.hpp"

namespace moraine {

/// Run-time numbers of a sweep, the same for all pairs.
struct SweepParameters {
  KernelName kernel = KernelName::wendland_c2;
  double smoothing_length = 0.0;  // h [m], of the case
  PairSmoothing of_pair = PairSmoothing::arithmetic;
  double position_scale = 1.0;                // metres per fixed-point unit
  double viscosity_alpha = 0.0;               // [-]
  double viscosity_beta = 0.0;                // [-]
  double viscous_signal = 0.6;                // share of alpha c + beta |mu| in the signal speed
  double density_diffusion = 0.0;             // delta [-]
  std::array<double, 3> gravity{};            // m/s^2
  std::array<double, 3> hydrostatic_slope{};  // g / c_0^2 [1/m], of the density diffusion
  std::array<double, 3> image_slope{};        // g / c_0^2 [1/m], of images at mirror walls
  bool volume_continuity = false;             // form of the continuity equation
  bool mixed_momentum = false;                // form of the pressure force
  bool summed_density = false;                // density is no state: nothing to predict
  double contact_gap = 1.0;                   // below this distance a wall pushes back [m]
  bool walls_move = false;                    // walls do work
  bool mirror_walls = false;                  // walls that make images of the fluid
  bool walls_keep_work = false;               // pairs with those images give all work to the fluid
  UniformFields<double> uniform{};

  /// The uniform fields as numbers of a record.
  template <class Slot>
  UniformFields<Slot> uniform_as() const {
    UniformFields<Slot> values{};
    for (std::size_t f = 0; f < pair_field_count; ++f) values[f] = static_cast<Slot>(uniform[f]);
    return values;
  }
};

}  // namespace moraine
