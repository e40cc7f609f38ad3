// The prescribed motion of a rigid body.
#pragma once

#include <array>

#include "base/vec3.hpp"
#include "motion/time_course.hpp"

namespace moraine {

/// Where a rigid body is at an instant, and how it moves.
///
///   x(x_0) = c + R (x_0 - c) + s,  v(x) = s' + w x r,  a(x) = s'' + w' x r + w x (w x r),
///   r = x - c - s
///
/// with the displacement s, the turn R about the axis through c, and the angular velocity w.
/// Source: Goldstein, Classical Mechanics (1980), eq. 4-86, for a body-fixed point.
class RigidState {
 public:
  RigidState() = default;
  /// `axis` of unit length; angle in rad.
  RigidState(Vec3 const& about, Vec3 const& axis, std::array<CourseState, 3> const& translation,
             CourseState const& angle);

  /// The place now of what was at x_0 before any motion [m].
  Vec3 place(Vec3 const& x_0) const;
  /// The place before any motion of what is at x now [m].
  Vec3 start_of(Vec3 const& x) const;
  /// A direction now that was `direction` before any motion.
  Vec3 turned(Vec3 const& direction) const;
  /// Of the body at the place x now [m/s, m/s^2].
  Vec3 velocity(Vec3 const& x) const;
  Vec3 acceleration(Vec3 const& x) const;

  Vec3 const& angular_velocity() const { return angular_velocity_; }  // rad/s

  /// Bounds of both for a body that reaches as far as `radius` [m] from the point turned about.
  double largest_speed(double radius) const;
  double largest_acceleration(double radius) const;

 private:
  Vec3 turned_by(double sine, Vec3 const& direction) const;

  Vec3 center_{};  // m, c + s
  Vec3 about_{};   // m, c
  Vec3 axis_{0.0, 0.0, 1.0};
  double sine_ = 0.0, cosine_ = 1.0;
  Vec3 velocity_{}, acceleration_{};                  // m/s, m/s^2, of the centre
  Vec3 angular_velocity_{}, angular_acceleration_{};  // rad/s, rad/s^2
};

/// A motion: a translation along each axis [m], then a turn [rad], right-handed about `axis`
/// (unit length) through `about`, which takes part in the translation.
struct RigidMotion {
  std::array<TimeCourse, 3> translation;
  TimeCourse rotation;
  Vec3 about{};
  Vec3 axis{0.0, 0.0, 1.0};

  RigidState at(double time) const;
};

}  // namespace moraine
