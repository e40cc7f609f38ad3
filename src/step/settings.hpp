// How a case is solved: resolution, schemes, time. Plain data, filled by the case file.
#pragma once

#include <cstdint>
#include <limits>

#include "smoothing/kernel_names.hpp"
#include "terms/options/option_parameters.hpp"

namespace moraine {

/// Arithmetic of the pair loops: `mixed` forms pairs in single precision over fixed-point positions
/// and keeps the state in double; `full` ("double" in case files) does all in double.
enum class Precision : std::uint8_t { mixed, full };

/// Where the density comes from: a state that the continuity equation advances, or a sum over
/// neighbours in every step, as it is or divided by the sum of volumes.
enum class DensityForm : std::uint8_t { continuity, summation, normalised };

/// What density diffusion leaves alone: the gradient of hydrostatic equilibrium, or any smooth one.
enum class DiffusionForm : std::uint8_t { hydrostatic, gradient };

/// Correction of the kernel gradient.
enum class GradientCorrection : std::uint8_t { off, bonet_lok };

/// Where the penalty between materials begins: at the spacing, or at the smoothing length.
enum class PenaltyRange : std::uint8_t { spacing, smoothing_length };

/// Repulsion between materials; docs/theory/sph.md.
struct PenaltySpec {
  double strength = 0.0;  // N in 2D, J in 3D; 0: none
  PenaltyRange range = PenaltyRange::spacing;
  int repulsion = 12;  // exponents
  int attraction = 6;
};

/// Weights of the continuity equation: by the neighbour's mass, or by its volume.
enum class ContinuityForm : std::uint8_t { mass, volume };

/// Forms of the pressure force: p_i / rho_i^2 + p_j / rho_j^2, or (p_i + p_j) / (rho_i rho_j).
enum class MomentumForm : std::uint8_t { conservative, mixed };

/// How the smoothing length of a particle follows its density, and h of a pair those of its two:
/// docs/theory/sph.md.
enum class SmoothingMode : std::uint8_t { constant, rate, density };

struct Smoothing {
  SmoothingMode mode = SmoothingMode::constant;
  PairSmoothing of_pair = PairSmoothing::arithmetic;
  double rate_share = 1.0;  // share of the rate that `rate` takes over
  double least = 0.5;       // bounds of h, by that of the case
  double most = 2.0;
  bool varies() const { return mode != SmoothingMode::constant; }
};

struct Numerics {
  KernelName kernel = KernelName::wendland_c2;
  double spacing = 0.0;           // m
  double smoothing_factor = 1.2;  // h / spacing
  Smoothing smoothing;
  double viscosity_alpha = 1.0;  // Monaghan, linear
  double viscosity_beta = 10.0;  // Monaghan, quadratic
  double density_diffusion = 0.0;
  DiffusionForm diffusion = DiffusionForm::hydrostatic;
  DensityForm density = DensityForm::continuity;
  ContinuityForm continuity = ContinuityForm::mass;
  MomentumForm momentum = MomentumForm::conservative;
  ViscosityForm physical_viscosity = ViscosityForm::off;
  double xsph = 0.0;      // epsilon
  double shifting = 0.0;  // coefficient
  GradientCorrection gradient_correction = GradientCorrection::off;
  PenaltySpec penalty;
  double artificial_stress = 0.0;  // epsilon, of solids in tension
  Precision precision = Precision::mixed;
  double smoothing_length() const { return smoothing_factor * spacing; }
  /// The least and the largest that a particle of the case can have [m].
  double least_smoothing_length() const {
    return smoothing_length() * (smoothing.varies() ? smoothing.least : 1.0);
  }
  double largest_smoothing_length() const {
    return smoothing_length() * (smoothing.varies() ? smoothing.most : 1.0);
  }
};

struct TimeSpec {
  double end = 0.0;      // s
  double courant = 0.3;  // factor of h / signal speed and of sqrt(h / a)
  double max_step = std::numeric_limits<double>::infinity();  // s
  double fixed_step = 0.0;                                    // s; 0: chosen by votes
};

}  // namespace moraine
