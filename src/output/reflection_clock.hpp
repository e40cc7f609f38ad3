// From when on a gauge may read what walls have reflected.
#pragma once

#include <cstdint>
#include <vector>

#include "base/archive.hpp"
#include "base/vec3.hpp"
#include "step/model.hpp"

namespace moraine {

/// Watches the pressure that walls of particles see. Where it has risen by `rise` [Pa] at place w,
/// at time t, what comes back is expected at place x from
///
///   t + |x - w| / c,
///
/// on, c the speed of sound at w then: sooner where the way back leads through faster material, and
/// where it is shocked. The earliest over all places of walls counts. Walls behind the
/// end of an absorbing layer do not count, nor do mirrors, free surfaces and interfaces.
class ReflectionClock {
 public:
  ReflectionClock(double rise, std::vector<Vec3> places)
      : rise_(rise), places_(std::move(places)), earliest_(places_.size(), never) {}

  /// Call at the start and after each step.
  void tell(Model const& model, double time);

  /// Of each place [s]; infinite as long as no wall has seen anything.
  std::vector<double> const& earliest() const { return earliest_; }

  void exchange(Archive& archive);

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  double rise_;
  std::vector<Vec3> places_;
  std::vector<double> earliest_;
  std::vector<double> first_;           // Pa, by number of the wall particle
  std::vector<std::uint8_t> has_seen_;  // the same
};

}  // namespace moraine
