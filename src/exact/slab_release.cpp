#include "exact/slab_release.hpp"

#include <stdexcept>

namespace moraine {

SlabRelease::SlabRelease(RiemannSide const& charge, std::optional<RiemannSide> const& outside,
                         double thickness)
    : waves_(outside ? RiemannProblem(charge, *outside) : RiemannProblem::into_vacuum(charge)),
      thickness_(thickness) {
  if (charge.velocity != 0.0)
    throw std::invalid_argument("slab release: the charge must be at rest before its wall");
  if (!(thickness > 0.0))
    throw std::invalid_argument("slab release: the thickness must be positive");
}

double SlabRelease::meeting_time() const { return -thickness_ / waves_.left_wave().head; }

FlowState SlabRelease::sample(double x, double time) const {
  if (!(time > 0.0 && time <= meeting_time()))
    throw std::invalid_argument("slab release: the time is not before the wave meets the wall");
  return waves_.sample((x - thickness_) / time);
}

}  // namespace moraine
