// One pair of particles as an optional term sees it, and what these terms add up to.
#pragma once

#include "base/macros.hpp"

namespace moraine {

template <class Real, int D>
struct OptionPair {
  Real x[D];       // x_ij [m]
  Real v[D];       // v_ij [m/s]
  Real distance2;  // |x_ij|^2 [m^2]
  Real h;          // smoothing length of the pair [m]
  Real kernel;     // W_ij [1/m^d]
  Real gradient;   // grad_i W_ij = gradient * x [1/m^(d+2)]
};

/// Sums of one particle. Unlike the terms of the main sweep these make force and heat themselves:
/// not all of them push along grad W.
template <class Real, int D>
struct OptionSum {
  Real acceleration[D];   // m/s^2
  Real drift[D];          // velocity of the place less that of the material [m/s]
  Real density_rate;      // kg/(m^3 s), without diffusion
  Real diffusion;         // kg/(m^3 s)
  Real energy_rate;       // W/kg, viscous heat included
  Real viscous_heat;      // W/kg
  Real penalty_force[D];  // N
  Real stiffness;         // of penalties [N/m]
  Real potential;         // of penalties, the particle's half of each pair [J]
};

}  // namespace moraine
