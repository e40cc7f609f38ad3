// Pair terms of solids: the gradient of the velocity, and the divergence of the deviatoric stress.
#pragma once

#include <tuple>

#include "base/macros.hpp"
#include "base/symmetric.hpp"
#include "terms/options/option_pair.hpp"
#include "terms/pair_fields.hpp"
#include "terms/sweep_parameters.hpp"

namespace moraine {

/// Sums of one particle.
template <class Real, int D>
struct StrengthSum {
  Real acceleration[D];  // m/s^2
  Real energy_rate;      // W/kg
  Real gradient[D * D];  // d v_a / d x_b, row by row [1/s]
};

/// What the records of a solid hold. Walls are those of the optional terms.
template <int D>
struct StrengthScheme {
  using Fluid = RecordLayout<D, PairField::velocity, PairField::mass, PairField::volume,
                             PairField::smoothing_length, PairField::stress_term>;
  using Wall =
      RecordLayout<D, PairField::velocity, PairField::wall_velocity, PairField::reference_density,
                   PairField::pressure_term, PairField::normal, PairField::wall_depth>;
};

/// The same with artificial stress.
template <int D>
struct TensionScheme {
  using Fluid = RecordLayout<D, PairField::velocity, PairField::mass, PairField::volume,
                             PairField::smoothing_length, PairField::stress_term,
                             PairField::artificial_stress>;
  using Wall = typename StrengthScheme<D>::Wall;
};

/// Share of a wall's normal in what is reflected there: all of it with free slip, nothing without.
template <class Wall>
MORAINE_FORMULA auto slipping_normal(Wall const& wall, int axis) {
  using Real = typename Wall::Number;
  return select(number<Real>(0) < wall_depth(wall), normal(wall, axis), number<Real>(0));
}

/// Gradient of the velocity.
///
///   L_i = sum_j (m_j / rho_j) (v_j - v_i) (x) grad_i W_ij
///
/// Source: Libersky et al., J. Comput. Phys. 109 (1993) 67, eqs 18 and 19. At a wall v_j is its
/// velocity, and with free slip only the difference along its normal counts, so that the trace is
/// that of the continuity equation there.
template <class Real>
struct VelocityGradient {
  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           StrengthSum<Real, D>& sum) const {
    Real v[D];  // v_ij
    Real weight = pair.gradient;
    if constexpr (wall) {
      weight = weight * lattice_volume(j);
      slipping_velocity<D>(i, j, v);
    } else {
      weight = weight * volume(j);
      for (int axis = 0; axis < D; ++axis) v[axis] = pair.v[axis];
    }
    for (int a = 0; a < D; ++a) {
      Real const weighted = weight * v[a];
      for (int b = 0; b < D; ++b) sum.gradient[a * D + b] -= weighted * pair.x[b];
    }
  }
};

/// Force of the deviatoric stress s, and its work.
///
///   conservative:  dv_i/dt += sum_j m_j (s_i / rho_i^2 + s_j / rho_j^2) . grad_i W_ij
///                  de_i/dt -= sum_j m_j v_ij . (s_i / rho_i^2) . grad_i W_ij
///   mixed:         the same with s_i / (rho_i rho_j) and s_j / (rho_i rho_j)
///
/// Source: Libersky et al. (1993), eqs 16 and 20. The work of a pair is that of its force, so that
/// kinetic and internal energy together are conserved: the strain that heats is summed with m_j /
/// rho_i, not with m_j / rho_j as the velocity gradient.
/// A fluid has s = 0, and its pairs with solids carry the solid's stress alone. A wall shows the
/// stress of the particle that looks at it: with free slip as in a mirror, R s R with R = 1 - 2 n
/// n, which leaves no shear along it; without slip, and where it has no normal, the same. In the
/// mixed form its mass drops out, as in its pressure. Its pairs give all of their work to the
/// particle.
template <class Real>
struct StressDivergence {
  bool mixed;

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           StrengthSum<Real, D>& sum) const {
    Real const weight = pair_weight<wall>(j) * pair.gradient;
    auto const own = [&i](int k) __attribute__((always_inline)) { return stress_term(i, k); };
    Real of_i[D], of_j[D];
    for (int axis = 0; axis < D; ++axis) of_i[axis] = row_times<D>(own, pair.x, axis);
    if constexpr (wall) {
      seen_in_wall(own, pair, j, of_j);
      if (mixed) {
        Real const ratio = mass(i) / (volume(i) * density(j));  // rho_i / rho_j
        for (int axis = 0; axis < D; ++axis) {
          of_i[axis] = of_i[axis] * ratio;
          of_j[axis] = of_j[axis] * ratio;
        }
      }
    } else {
      auto const other = [&j](int k) __attribute__((always_inline)) { return stress_term(j, k); };
      for (int axis = 0; axis < D; ++axis) of_j[axis] = row_times<D>(other, pair.x, axis);
      if (mixed) {
        Real const ratio = mass(i) * volume(j) / (volume(i) * mass(j));  // rho_i / rho_j
        Real const inverse = number<Real>(1) / ratio;
        for (int axis = 0; axis < D; ++axis) {
          of_i[axis] = of_i[axis] * ratio;
          of_j[axis] = of_j[axis] * inverse;
        }
      }
    }
    Real work = number<Real>(0);
    for (int axis = 0; axis < D; ++axis) {
      sum.acceleration[axis] += weight * (of_i[axis] + of_j[axis]);
      if constexpr (wall)
        work += (of_i[axis] + of_j[axis]) * (velocity(i, axis) - wall_velocity(j, axis));
      else
        work += of_i[axis] * pair.v[axis];
    }
    sum.energy_rate -= weight * work;
  }

 private:
  /// R s_i R x_ij.
  template <int D, class Own, class Wall>
  MORAINE_FORMULA static void seen_in_wall(Own const& own, OptionPair<Real, D> const& pair,
                                           Wall const& wall, Real (&seen)[D]) {
    Real x[D], turned[D];
    for (int axis = 0; axis < D; ++axis) x[axis] = pair.x[axis];
    reflect<D>(wall, x);
    for (int axis = 0; axis < D; ++axis) turned[axis] = row_times<D>(own, x, axis);
    reflect<D>(wall, turned);
    for (int axis = 0; axis < D; ++axis) seen[axis] = turned[axis];
  }

  template <int D, class Wall>
  MORAINE_FORMULA static void reflect(Wall const& wall, Real (&vector)[D]) {
    Real along = number<Real>(0);
    for (int axis = 0; axis < D; ++axis) along += vector[axis] * slipping_normal(wall, axis);
    for (int axis = 0; axis < D; ++axis)
      vector[axis] -= number<Real>(2) * along * slipping_normal(wall, axis);
  }
};

/// Repulsion of particles that are close to each other in a solid under tension, which would clump.
///
///   dv_i/dt += sum_j m_j f^4 (R_i + R_j) . grad_i W_ij,   f = W(r) / W(spacing)
///   de_i/dt -= 1/2 sum_j m_j f^4 v_ij . (R_i + R_j) . grad_i W_ij
///
/// with R of a particle from its principal stresses (terms/strength/artificial_stress.hpp). Source:
/// Gray, Monaghan & Swift, Comput. Methods Appl. Mech. Eng. 190 (2001) 6641, eqs 27 to 34. The
/// spacing is that of the lattice, or of the smoothing length where that varies.
template <class Real>
struct TensionRepulsion {
  Real kernel_at_spacing;  // W h^d at q = 1 / smoothing_factor

  template <bool wall, int D, class Self, class Neighbour>
  MORAINE_FORMULA void add(OptionPair<Real, D> const& pair, Self const& i, Neighbour const& j,
                           StrengthSum<Real, D>& sum) const {
    if constexpr (Self::has(PairField::artificial_stress) && !wall) {
      Real const volume_of_h = D == 1   ? pair.h
                               : D == 2 ? pair.h * pair.h
                                        : pair.h * pair.h * pair.h;
      Real const f = pair.kernel * volume_of_h / kernel_at_spacing;
      Real const weight = pair_weight<false>(j) * pair.gradient * (f * f) * (f * f);
      auto const both = [&i, &j ](int k) __attribute__((always_inline)) {
        return artificial_stress(i, k) + artificial_stress(j, k);
      };
      Real work = number<Real>(0);
      for (int axis = 0; axis < D; ++axis) {
        Real const push = row_times<D>(both, pair.x, axis);
        sum.acceleration[axis] += weight * push;
        work += push * pair.v[axis];
      }
      sum.energy_rate -= number<Real>(0.5) * weight * work;
    }
  }
};

/// kernel_at_spacing: of TensionRepulsion; means nothing without artificial stress.
template <class Real>
auto strength_terms(SweepParameters const& sweep, double kernel_at_spacing) {
  return std::tuple{VelocityGradient<Real>{}, StressDivergence<Real>{sweep.mixed_momentum},
                    TensionRepulsion<Real>{number<Real>(kernel_at_spacing)}};
}

}  // namespace moraine
