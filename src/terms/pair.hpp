// One pair of particles as a term sees it, and what a term gives back.
#pragma once

#include "base/macros.hpp"

namespace moraine {

/// What all terms of a pair share; lanes of many neighbours when Real is a vector.
///
/// `inverse` is the one division of the pair loop: terms that divide by a density or by r^2 use it.
template <class Real, int D>
struct Pair {
  Real x[D];          // x_ij = x_i - x_j [m]
  Real distance2;     // |x_i - x_j|^2 [m^2]
  Real h;             // smoothing length of the pair [m]
  Real gradient;      // grad_i W_ij = gradient * x [1/m^(d+2)]
  Real approach;      // v_ij . x [m^2/s], negative when the two come closer; at a free-slip wall
                      // only the parts along its normal
  Real gap;           // wall pairs only: distance of i in front of the face of j [m]
  Real mean_density;  // (rho_i + rho_j) / 2 [kg/m^3]
  Real inverse;       // 1 / (mean_density (distance2 + phi^2)) [m/kg], phi = 0.1 h
};

/// What the terms of one pair add up to, per unit mass of the neighbour.
///
/// A term that pushes the two particles along grad W adds to `stress`: the sweep turns it into the
/// momentum and its compatible energy,
///   dv_i/dt = - sum_j m_j S_ij grad_i W_ij,   de_i/dt = 1/2 sum_j m_j S_ij v_ij . grad_i W_ij,
/// so that any S_ij symmetric in i and j conserves momentum and total energy by construction.
template <class Real>
struct PairRates {
  Real stress;          // S_ij [Pa m^6/kg^2]
  Real density_rate;    // d rho_i / dt per neighbour mass [1/(m^3 s)]
  Real approach_speed;  // h v_ij . x_ij / (r^2 + phi^2), <= 0 [m/s], for the time-step vote
};

}  // namespace moraine
