// Kernels for a dimension that is known only at run time; for probes, not for loops
// over all pairs.
#pragma once

#include <type_traits>

#include "smoothing/any_kernel.hpp"

namespace moraine {

/// use(kernel) with the kernel of this name in 1, 2 or 3 dimensions.
template <class Use>
double with_kernel(KernelName name, int dimension, Use&& use) {
  auto const of = [&]<int D>(std::integral_constant<int, D>) { return use(AnyKernel<D>(name)); };
  if (dimension == 1) return of(std::integral_constant<int, 1>{});
  if (dimension == 2) return of(std::integral_constant<int, 2>{});
  return of(std::integral_constant<int, 3>{});
}

/// The kernel without its normalisation, at q = r / h.
inline double kernel_shape(KernelName name, int dimension, double q) {
  return with_kernel(name, dimension, [q](auto kernel) { return kernel.shape(q); });
}

/// sigma_d: the kernel is sigma_d / h^d times its shape.
inline double kernel_sigma(KernelName name, int dimension) {
  return with_kernel(name, dimension, [](auto kernel) { return kernel.sigma; });
}

}  // namespace moraine
