// How much of the kernel around a place is filled with fluid.
#pragma once

#include <cmath>

#include "base/vec3.hpp"
#include "probes/kernel_shape.hpp"
#include "search/search.hpp"
#include "smoothing/kernel_names.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// s(x) = sum_j (m_j / rho_j) W(x - x_j) over the fluid particles for which counts(j) is true, with
/// those beyond periodic sides and symmetry planes; 1 in the depth, 1/2 at a flat surface. h in m.
template <class Counts>
double filled_share(ParticleStore const& store, Search const& search, KernelName kernel, double h,
                    Vec3 const& x, Counts&& counts) {
  double sum = 0.0;
  search.for_each_fluid_near(
      x, kernel_support * h, [&](std::size_t i, Search::Viewpoint const& from) {
        if (!counts(i)) return;
        double distance2 = 0.0;
        for (int axis = 0; axis < store.dimension(); ++axis) {
          double const d = from.place[static_cast<std::size_t>(axis)] -
                           store.component(Field::position, axis)[i];
          distance2 += d * d;
        }
        if (distance2 < kernel_support * kernel_support * h * h)
          sum += store.scalar(Field::mass)[i] / store.scalar(Field::density)[i] *
                 kernel_shape(kernel, store.dimension(), std::sqrt(distance2) / h);
      });
  return sum * kernel_sigma(kernel, store.dimension()) / std::pow(h, store.dimension());
}

}  // namespace moraine
