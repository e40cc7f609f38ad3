#include "exact/riemann.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

double stiffness(WaveCurve const& curve) {
  IsentropeState const& at = curve.isentrope().start();
  return at.density * at.sound_speed * at.sound_speed;
}

char const* apart(WaveCurve const& left, WaveCurve const& right) {
  auto const ends_by = [](WaveCurve const& curve) { return curve.isentrope().ends_by(); };
  bool const liquid = ends_by(left) == IsentropeEnd::floor || ends_by(right) == IsentropeEnd::floor;
  return liquid ? "Riemann problem: the states move apart and the liquid cavitates"
                : "Riemann problem: the states move apart and leave a vacuum";
}

// The pressure at which both waves give the contact one velocity. `closing` is u_left - u_right.
double common_pressure(WaveCurve const& left, WaveCurve const& right, double closing) {
  auto const mismatch = [&](double p) { return left.velocity(p) + right.velocity(p) - closing; };
  double const low = std::max(left.isentrope().end().pressure, right.isentrope().end().pressure);
  if (mismatch(low) > 0.0) throw std::domain_error(apart(left, right));
  double high = std::max(left.ahead().pressure, right.ahead().pressure);
  double rise = std::min(stiffness(left), stiffness(right));
  for (; mismatch(high) < 0.0; rise *= 2.0) high += rise;
  return bisect(mismatch, low, high);
}

FlowState moved(FlowState state, double velocity) {
  state.velocity += velocity;
  return state;
}

// The state on the ray `speed` in the wave that runs towards +x into a material of `velocity`.
FlowState on_ray(WaveCurve const& curve, Wave const& wave, double velocity, double speed) {
  if (speed > wave.head) return moved(curve.ahead(), velocity);
  if (speed > wave.tail) return moved(curve.inside(speed - velocity), velocity);
  return wave.behind;
}

Wave mirrored(Wave const& wave) {
  return {wave.kind, -wave.head, -wave.tail, mirrored(wave.behind)};
}

}  // namespace

RiemannProblem::RiemannProblem(RiemannSide const& left, RiemannSide const& right)
    : RiemannProblem(left, std::optional<RiemannSide>(right)) {}

RiemannProblem RiemannProblem::into_vacuum(RiemannSide const& left) {
  return RiemannProblem(left, std::nullopt);
}

RiemannProblem::RiemannProblem(RiemannSide const& left, std::optional<RiemannSide> const& right)
    : left_(left.law, left.density, left.specific_energy), left_velocity_(left.velocity) {
  if (right) {
    right_.emplace(right->law, right->density, right->specific_energy);
    right_velocity_ = right->velocity;
    star_pressure_ = common_pressure(left_, *right_, left_velocity_ - right_velocity_);
    right_wave_ = in_frame(right_->wave(star_pressure_), right_velocity_, false);
  } else {
    star_pressure_ = std::max(0.0, left_.isentrope().end().pressure);
  }
  left_wave_ = in_frame(left_.wave(star_pressure_), left_velocity_, true);
  star_velocity_ = left_wave_.behind.velocity;
  if (right_wave_) star_velocity_ = 0.5 * (star_velocity_ + right_wave_->behind.velocity);
}

FlowState RiemannProblem::sample(double x_over_t) const {
  if (x_over_t < star_velocity_)
    return mirrored(on_ray(left_, mirrored(left_wave_), -left_velocity_, -x_over_t));
  if (!right_) return {};
  // On a shock the state of the right side is the one ahead.
  if (right_wave_->kind == WaveKind::shock && x_over_t >= right_wave_->head)
    return moved(right_->ahead(), right_velocity_);
  return on_ray(*right_, *right_wave_, right_velocity_, x_over_t);
}

}  // namespace moraine
