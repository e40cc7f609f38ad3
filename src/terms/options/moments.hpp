// Moments of the neighbourhood of a particle, and what is made of them.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/symmetric.hpp"
#include "smoothing/kernel_names.hpp"
#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// Sums over neighbours with their volumes V_j = m_j / rho_j.
template <class Real, int D>
struct MomentSum {
  Real matrix[symmetric_size<D>];  // - sum_j V_j x_ij (x) grad_i W_ij [-]
  Real concentration[D];           // sum_j V_j grad_i W_ij [1/m]
  Real density_slope[D];           // sum_j V_j (rho_j - rho_i) grad_i W_ij [kg/m^4]
  Real fastest2;                   // max_j |v_ij|^2 within the support, dummies apart [m^2/s^2]
};

/// Adds one neighbour; with `of_one_material` only those of the same reference density.
template <class Real>
struct Moments {
  bool of_one_material;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           MomentSum<Real, D>& sum) const {
    Real volume = number<Real>(0);
    if constexpr (wall)
      volume = lattice_volume(j);
    else
      volume = mass(j) / density(j);
    if constexpr (!wall) {
      Real speed2 = number<Real>(0);
      for (int a = 0; a < D; ++a) speed2 += pair.v[a] * pair.v[a];
      Real const near = number<Real>(kernel_support) * pair.h;
      sum.fastest2 =
          maximum(sum.fastest2, select(pair.distance2 < near * near, speed2, number<Real>(0)));
      if (of_one_material)
        volume = select(reference_density(i) == reference_density(j), volume, number<Real>(0));
    }
    Real const weight = volume * pair.gradient;
    Real const difference = reference_density(i) * (compression(j) - compression(i));
    for (int a = 0; a < D; ++a) {
      sum.concentration[a] += weight * pair.x[a];
      if constexpr (!wall) sum.density_slope[a] += weight * pair.x[a] * difference;
      for (int b = a; b < D; ++b)
        sum.matrix[symmetric_index<D>(static_cast<std::size_t>(a), static_cast<std::size_t>(b))] -=
            weight * pair.x[a] * pair.x[b];
    }
  }
};

/// K = s (M^-1 - 1), which makes the kernel gradient exact for linear fields: L grad W, L = 1 + K.
///
/// Source: Bonet & Lok, Comput. Methods Appl. Mech. Eng. 180 (1999) 97. M: the sum
/// `matrix`, the unit matrix where neighbours are all around. Where they are few M is nearly
/// singular: s falls from 1 to 0 while sqrt(d) / |M^-1|, which is 1 inside, 0.5 to 0.7 at a
/// straight free surface and tends to M's smallest eigenvalue times sqrt(d), falls from 0.4 to 0.2;
/// own choice. |M^-1|: root of the sum of squares.
template <int D>
Symmetric<D> gradient_correction(Symmetric<D> const& m) {
  Symmetric<D> correction{};
  Cofactors<D> const of_m = cofactors<D>(m);
  double const size = frobenius_norm<D>(of_m.adjugate);
  if (!(of_m.determinant > 0.0) || !(size > 0.0)) return correction;
  double const soundness = std::sqrt(static_cast<double>(D)) * of_m.determinant / size;
  double const share = std::clamp((soundness - 0.2) / 0.2, 0.0, 1.0);
  for (std::size_t k = 0; k < correction.size(); ++k) {
    double const unit = k < static_cast<std::size_t>(D) ? 1.0 : 0.0;
    correction[k] = share * (of_m.adjugate[k] / of_m.determinant - unit);
  }
  return correction;
}

/// Velocity [m/s] that takes particles to where there are fewer of them.
///
///   dv_i = - A h_i U_i f_i grad C_i,   at most U_i / 2,   U_i = max_j |v_ij|,
///   f_i = clamp((tr M / d - 0.75) / 0.2)
///
/// Source: Lind, Xu, Stansby & Rogers, J. Comput. Phys. 231 (2012) 1499, with the diffusion
/// coefficient of Skillen et al., Comput. Methods Appl. Mech. Eng. 265 (2013) 163: A |v| h
/// dt. grad C: sum `concentration`. f: own choice; the trace of M, the divergence of position of
/// Lee et al., J. Comput. Phys. 227 (2008) 8417, is d inside and about d / 2 at a free surface, so
/// that nothing is shifted there. Departure: U_i where the source has |v_i|, which shifts a liquid
/// that travels as a whole and nothing at a point of stagnation, where flow draws particles into
/// lines. U is about 2 h |grad v|: what shifting does while a flow deforms a neighbourhood depends
/// on A alone, at any spacing. A of 20 to 40 keeps vortices even; the source has 2 |v|.
/// Range: U much slower than sound / A; beyond, the bound decides and places tremble.
template <int D>
std::array<double, 3> shifting_velocity(double coefficient, double h,
                                        MomentSum<double, D> const& moments) {
  double const speed = std::sqrt(moments.fastest2);
  double divergence = 0.0;
  double slope2 = 0.0;
  for (int a = 0; a < D; ++a) {
    divergence += moments.matrix[a];
    slope2 += moments.concentration[a] * moments.concentration[a];
  }
  double const inside = std::clamp((divergence / D - 0.75) / 0.2, 0.0, 1.0);
  double const wanted = coefficient * h * speed * inside;
  double const length = wanted * std::sqrt(slope2);
  double const factor = length > 0.5 * speed ? wanted * 0.5 * speed / length : wanted;
  std::array<double, 3> velocity{};
  for (int a = 0; a < D; ++a)
    velocity[static_cast<std::size_t>(a)] = -factor * moments.concentration[a];
  return velocity;
}

}  // namespace moraine
