// The fluid's state at a fixed point.
#pragma once

#include <array>

#include "search/search.hpp"
#include "smoothing/kernel_names.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Interpolated state; not a number everywhere when no fluid is near.
struct PointState {
  double pressure;                 // Pa
  double density;                  // kg/m^3
  double specific_energy;          // J/kg
  std::array<double, 3> velocity;  // m/s
};

/// Shepard interpolation over the fluid particles within the support,
///   f(x) = sum_j f_j V_j W(x - x_j) / sum_j V_j W(x - x_j),  V_j = m_j / rho_j.
/// Source: Randles & Libersky, Comput. Methods Appl. Mech. Eng. 139 (1996) 375, section 3. Exact
/// for constant fields, also at free surfaces. h in m.
PointState probe_point(ParticleStore const& store, KernelName kernel, double h,
                       std::array<double, 3> const& x);

/// The same with the cells of a search whose lists hold: only particles nearby are looked at, and
/// those beyond periodic sides count too. Summed in the order of the cells, hence the same bits for
/// any number of threads.
PointState probe_point(ParticleStore const& store, Search const& search, KernelName kernel,
                       double h, std::array<double, 3> const& x);

/// Largest (direction +1) or smallest (-1) coordinate along an axis of a material's particles [m];
/// not a number when there are none.
double probe_front(ParticleStore const& store, MaterialId material, int axis, int direction);

}  // namespace moraine
