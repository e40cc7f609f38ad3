// Release of a slab of explosive that has burnt in an instant.
#pragma once

#include <optional>

#include "exact/riemann.hpp"

namespace moraine {

/// Products at rest between a rigid wall (or plane of symmetry) x = 0 and their face x = thickness,
/// and what is outside of the face. At t = 0 the face is let go: a rarefaction runs into the
/// products, and a shock into the material outside. Exact until the rarefaction's head meets the
/// wall, at thickness / c_0; outside is half a space.
///
/// The whole charge at the energy of the explosive is the "instantaneous" burn, with the pressure
/// that the law has at the density of the solid.
class SlabRelease {
 public:
  /// `outside` nothing: vacuum. `charge.velocity` must be 0 and `thickness` positive, else
  /// std::invalid_argument; more errors as those of RiemannProblem.
  SlabRelease(RiemannSide const& charge, std::optional<RiemannSide> const& outside,
              double thickness);

  RiemannProblem const& waves() const { return waves_; }
  /// When the head of the rarefaction meets the wall [s].
  double meeting_time() const;
  /// At x >= 0 and 0 < `time` <= meeting_time(), beyond which std::invalid_argument.
  FlowState sample(double x, double time) const;

 private:
  RiemannProblem waves_;
  double thickness_;
};

}  // namespace moraine
