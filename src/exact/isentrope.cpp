#include "exact/isentrope.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double relative_error = 1e-13;  // per step
constexpr double first_step = 1e-3;       // in ln(rho)
constexpr double least_step = 1e-13;
constexpr double longest_step = 0.5;
constexpr double escaped = 1e-12;     // sound speed over that of the start
constexpr double emptiest = 1e-200;   // density over that of the start
constexpr double mismatch = 1e-6;     // of the fall of pressure in a step, beyond: the floor
constexpr double rounding = 1e-12;    // of rho c^2, in pressures
constexpr double tiny_value = 1e-30;  // absolute error, for components that are zero

}  // namespace

Isentrope::Isentrope(Law law, double density, double specific_energy)
    : law_(std::move(law)),
      density_(density),
      sound_speed_(density > 0.0 ? law_.sound_speed(density, specific_energy) : 0.0) {
  if (!(sound_speed_ > 0.0 && std::isfinite(sound_speed_)))
    throw std::invalid_argument("isentrope: the state has no density or no sound speed");
  double const c2 = sound_speed_ * sound_speed_;
  Vector const y{specific_energy / c2, 0.0,
                 law_.pressure(density, specific_energy) / (density * c2)};
  depths_ = {0.0};
  knots_ = {y};
  states_ = {state(y, 0.0)};
  integrate();
}

IsentropeState Isentrope::state(Vector const& y, double s) const {
  double const rho = density_ * std::exp(-s);
  double const e = y[0] * sound_speed_ * sound_speed_;
  return {rho, e, law_.pressure(rho, e), law_.sound_speed(rho, e), y[1] * sound_speed_};
}

Isentrope::Vector Isentrope::rate(Vector const& y, double s) const {
  IsentropeState const at = state(y, s);
  double const c2 = sound_speed_ * sound_speed_;
  return {-at.pressure / (at.density * c2), at.sound_speed / sound_speed_,
          -at.density * at.sound_speed * at.sound_speed / (density_ * c2)};
}

bool Isentrope::admits(Vector const& y, double s) const {
  IsentropeState const at = state(y, s);
  return at.sound_speed > 0.0 && std::isfinite(at.sound_speed) && std::isfinite(at.pressure);
}

Isentrope::Vector Isentrope::stepped(std::size_t knot, double size) const {
  odeint::runge_kutta_fehlberg78<Vector> stepper;
  Vector y = knots_[knot];
  stepper.do_step([this](Vector const& x, Vector& dx, double s) { dx = rate(x, s); }, y,
                  depths_[knot], size);
  return y;
}

void Isentrope::integrate() {
  auto stepper =
      odeint::make_controlled(tiny_value, relative_error, odeint::runge_kutta_fehlberg78<Vector>());
  auto const system = [this](Vector const& y, Vector& dy, double s) { dy = rate(y, s); };
  double size = first_step;
  for (;;) {
    Vector y = knots_.back();
    double s = depths_.back();
    double const tried = size;
    if (stepper.try_step(system, y, s, size) == odeint::fail) {
      if (size < least_step) break;
      continue;
    }
    if (!admits(y, s)) {
      size = 0.5 * tried;
      if (size < least_step) break;
      continue;
    }
    IsentropeState const reached = state(y, s);
    double const scale = density_ * sound_speed_ * sound_speed_;
    double const fall = knots_.back()[2] - y[2];
    double const stiffness = reached.density * reached.sound_speed * reached.sound_speed / scale;
    if (std::fabs(reached.pressure / scale - y[2]) > mismatch * fall + rounding * stiffness)
      return end_at_floor(s - depths_.back());
    y[2] = reached.pressure / scale;
    depths_.push_back(s);
    knots_.push_back(y);
    states_.push_back(reached);
    size = std::min(size, longest_step);
    if (reached.sound_speed < escaped * sound_speed_ || reached.density < emptiest * density_)
      return end_in_vacuum();
  }
  ends_by_ = IsentropeEnd::no_sound_speed;
}

// Without a floor the pressure would be what is integrated: where that meets the floor, it begins.
void Isentrope::end_at_floor(double size) {
  std::size_t const knot = knots_.size() - 1;
  double const s = depths_.back();
  double const scale = density_ * sound_speed_ * sound_speed_;
  double const floor = state(stepped(knot, size), s + size).pressure / scale;
  double const part = bisect([&](double h) { return stepped(knot, h)[2] - floor; }, 0.0, size);
  knots_.push_back(stepped(knot, part));
  depths_.push_back(s + part);
  states_.push_back(state(knots_.back(), depths_.back()));
  states_.back().pressure = floor * scale;
  ends_by_ = IsentropeEnd::floor;
}

void Isentrope::end_in_vacuum() {
  ends_by_ = IsentropeEnd::vacuum;
  IsentropeState const& last = states_.back();
  if (!(last.pressure > 0.0)) return;
  double const gamma = last.density * last.sound_speed * last.sound_speed / last.pressure;
  if (!(gamma > 1.0)) return;
  double const rest = 2.0 * last.sound_speed / (gamma - 1.0);
  states_.push_back({0.0, 0.0, 0.0, 0.0, last.velocity_change + rest});
}

IsentropeState Isentrope::where(std::function<double(IsentropeState const&)> const& excess) const {
  if (!(excess(states_.front()) > 0.0)) return states_.front();
  auto const first_below = std::partition_point(
      states_.begin(), states_.end(), [&](IsentropeState const& at) { return excess(at) > 0.0; });
  auto const next = static_cast<std::size_t>(first_below - states_.begin());
  if (next >= knots_.size()) return states_.back();
  std::size_t const knot = next - 1;
  double const size =
      bisect([&](double h) { return excess(state(stepped(knot, h), depths_[knot] + h)); }, 0.0,
             depths_[next] - depths_[knot]);
  return state(stepped(knot, size), depths_[knot] + size);
}

IsentropeState Isentrope::at_pressure(double p) const {
  return where([p](IsentropeState const& at) { return at.pressure - p; });
}

bool Isentrope::spreads() const {
  for (std::size_t k = 1; k < states_.size(); ++k)
    if (states_[k].sound_speed - states_[k].velocity_change >
        states_[k - 1].sound_speed - states_[k - 1].velocity_change)
      return false;
  return true;
}

}  // namespace moraine
