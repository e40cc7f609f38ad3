// One pair of particles as an optional term sees it, and what these terms add up to.
#pragma once

#include "base/macros.hpp"
#include "terms/pair_fields.hpp"

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

/// v_ij as continuity and strain see it at a wall: with free slip only the part along its normal,
/// behind edges and corners, which have none, and without slip all of it (look_at_wall in
/// terms/sweep.hpp).
template <int D, class Real, class Self, class Wall>
MORAINE_FORMULA void slipping_velocity(Self const& i, Wall const& j, Real (&v)[D]) {
  Real along = number<Real>(0);
  Real length2 = number<Real>(0);
  for (int axis = 0; axis < D; ++axis) {
    v[axis] = velocity(i, axis) - wall_velocity(j, axis);
    along += v[axis] * normal(j, axis);
    length2 += normal(j, axis) * normal(j, axis);
  }
  for (int axis = 0; axis < D; ++axis)
    v[axis] = select(number<Real>(0) < wall_depth(j),
                     along * normal(j, axis) + (number<Real>(1) - length2) * v[axis], v[axis]);
}

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
