// Numbers of the optional pair terms, the same for all pairs.
#pragma once

#include <cstdint>

namespace moraine {

/// Physical viscosity between particles; terms/options/physical_viscosity.hpp.
enum class ViscosityForm : std::uint8_t { off, morris, monaghan_cleary };

/// What belongs to an option that is off is zero. Smoothing, kernel and the forms of pressure and
/// continuity are those of the main sweep (terms/sweep_parameters.hpp).
struct OptionParameters {
  ViscosityForm viscosity = ViscosityForm::off;
  double xsph = 0.0;                // epsilon [-]
  double gradient_diffusion = 0.0;  // delta of the density diffusion, where it takes gradients out
  bool corrected_gradient = false;
  double shifting = 0.0;          // coefficient of the particle shifting [-]
  double penalty_strength = 0.0;  // N in 2D, J in 3D
  double penalty_range = 0.0;     // share of h_i + h_j at which the penalty begins [-]
  int penalty_repulsion = 12;     // exponents
  int penalty_attraction = 6;

  /// Whether the terms need corrections, or gradients of density, of the particles.
  bool needs_gradients() const { return gradient_diffusion > 0.0 || corrected_gradient; }
  bool moves_places() const { return xsph > 0.0 || shifting > 0.0; }
  bool any() const {
    return needs_gradients() || moves_places() || viscosity != ViscosityForm::off ||
           penalty_strength > 0.0;
  }
};

}  // namespace moraine
