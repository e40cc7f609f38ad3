#include "motion/rigid_motion.hpp"

#include <cmath>

namespace moraine {

RigidState::RigidState(Vec3 const& about, Vec3 const& axis,
                       std::array<CourseState, 3> const& translation, CourseState const& angle)
    : about_(about), axis_(axis), sine_(std::sin(angle.value)), cosine_(std::cos(angle.value)) {
  for (std::size_t k = 0; k < 3; ++k) {
    center_[k] = about[k] + translation[k].value;
    velocity_[k] = translation[k].rate;
    acceleration_[k] = translation[k].second_rate;
  }
  angular_velocity_ = scale(angle.rate, axis);
  angular_acceleration_ = scale(angle.second_rate, axis);
}

/// Rodrigues' formula.
Vec3 RigidState::turned_by(double sine, Vec3 const& direction) const {
  Vec3 const along = scale((1.0 - cosine_) * dot(axis_, direction), axis_);
  return add(add(scale(cosine_, direction), scale(sine, cross(axis_, direction))), along);
}

Vec3 RigidState::turned(Vec3 const& direction) const { return turned_by(sine_, direction); }

Vec3 RigidState::place(Vec3 const& x_0) const {
  return add(center_, turned(subtract(x_0, about_)));
}

Vec3 RigidState::start_of(Vec3 const& x) const {
  return add(about_, turned_by(-sine_, subtract(x, center_)));
}

Vec3 RigidState::velocity(Vec3 const& x) const {
  return add(velocity_, cross(angular_velocity_, subtract(x, center_)));
}

Vec3 RigidState::acceleration(Vec3 const& x) const {
  Vec3 const arm = subtract(x, center_);
  Vec3 const inward = cross(angular_velocity_, cross(angular_velocity_, arm));
  return add(acceleration_, add(cross(angular_acceleration_, arm), inward));
}

double RigidState::largest_speed(double radius) const {
  return norm(velocity_) + norm(angular_velocity_) * radius;
}

double RigidState::largest_acceleration(double radius) const {
  double const spin2 = dot(angular_velocity_, angular_velocity_);
  return norm(acceleration_) + (norm(angular_acceleration_) + spin2) * radius;
}

RigidState RigidMotion::at(double time) const {
  return {about,
          axis,
          {translation[0].at(time), translation[1].at(time), translation[2].at(time)},
          rotation.at(time)};
}

}  // namespace moraine
