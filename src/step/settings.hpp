// How a case is solved: resolution, schemes, time. Plain data, filled by the case file.
#pragma once

#include <cstdint>
#include <limits>

#include "smoothing/kernels.hpp"
#include "smoothing/pair_smoothing.hpp"

namespace moraine {

/// Arithmetic of the pair loops: `mixed` forms pairs in single precision over fixed-point positions
/// and keeps the state in double; `full` ("double" in case files) does all in double.
enum class Precision : std::uint8_t { mixed, full };

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
  double least = 0.5;  // bounds of h, by that of the case
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
  ContinuityForm continuity = ContinuityForm::mass;
  MomentumForm momentum = MomentumForm::conservative;
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
