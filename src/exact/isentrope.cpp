#include "exact/isentrope.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

namespace odeint = boost::numeric::odeint;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-13;  // of a step, relative
constexpr double first_step = 1e-3;  // in ln(rho)
constexpr double least_step = 1e-13;
constexpr double longest_step = 0.5;
constexpr double escaped = 1e-12;    // sound speed over that of the start
constexpr double torn = 1e-3;        // the same under tension
constexpr double emptiest = 1e-200;  // density over that of the start
constexpr double mismatch = 1e-6;    // of the fall of pressure in a step, beyond: the floor
constexpr double rounding = 1e-14;   // of rho c^2 at the start, in pressures

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
  double const rho = density_ * std::exp(-s);
  double const start = sound_speed_ * sound_speed_;
  double const e = y[0] * start;
  double const c2 = law_.sound_speed_squared(rho, e);
  return {-law_.pressure(rho, e) / (rho * start), signed_root(c2) / sound_speed_,
          -rho * c2 / (density_ * start)};
}

bool Isentrope::admits(Vector const& y, double s) const {
  IsentropeState const at = state(y, s);
  return at.sound_speed > 0.0 && std::isfinite(at.sound_speed) && std::isfinite(at.pressure);
}

Isentrope::Vector Isentrope::stepped(Vector const& from, double s, double size) const {
  odeint::runge_kutta_fehlberg78<Vector> stepper;
  Vector y = from;
  stepper.do_step([this](Vector const& x, Vector& dx, double at) { dx = rate(x, at); }, y, s, size);
  return y;
}

// Difference of two results of a step over what is allowed, e, w and p measured by c^2, c, rho c^2.
double Isentrope::error(Vector const& a, Vector const& b, double s) const {
  IsentropeState const at = state(b, s);
  double const c = at.sound_speed / sound_speed_;
  double const scale[] = {c * c, c, at.density / density_ * c * c};
  double worst = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
    worst = std::max(worst, std::fabs(a[k] - b[k]) / (std::fabs(b[k]) + scale[k]));
  return worst / tolerance;
}

void Isentrope::add_knot(Vector y, double s) {
  IsentropeState const reached = state(y, s);
  y[2] = reached.pressure / (density_ * sound_speed_ * sound_speed_);
  depths_.push_back(s);
  knots_.push_back(y);
  states_.push_back(reached);
}

bool Isentrope::met_floor(Vector const& y, double s) const {
  IsentropeState const reached = state(y, s);
  double const unit = density_ * sound_speed_ * sound_speed_;
  double const fall = knots_.back()[2] - y[2];
  return std::fabs(reached.pressure / unit - y[2]) > mismatch * fall + rounding;
}

void Isentrope::integrate() {
  double size = first_step;
  while (size > least_step) {
    double const s = depths_.back(), half = 0.5 * size;
    Vector const whole = stepped(knots_.back(), s, size);
    Vector const middle = stepped(knots_.back(), s, half);
    Vector const y = stepped(middle, s + half, half);
    double const wrong =
        admits(middle, s + half) && admits(y, s + size) ? error(whole, y, s + size) : infinity;
    if (!(wrong <= 1.0)) {
      size *= wrong < infinity ? std::clamp(0.9 * std::pow(wrong, -1.0 / 9.0), 0.1, 0.5) : 0.5;
      continue;
    }
    if (met_floor(middle, s + half)) return end_at_floor(half);
    add_knot(middle, s + half);
    if (met_floor(y, s + size)) return end_at_floor(half);
    add_knot(y, s + size);
    IsentropeState const& last = states_.back();
    if (last.pressure < 0.0 && last.sound_speed < torn * sound_speed_) break;
    if (last.sound_speed < escaped * sound_speed_ || last.density < emptiest * density_)
      return end_in_vacuum();
    size = std::min(longest_step, size * std::min(4.0, 0.9 * std::pow(wrong, -1.0 / 9.0)));
  }
  ends_by_ = IsentropeEnd::rupture;
}

// Without a floor the pressure would be what is integrated: where that meets the floor, it begins.
void Isentrope::end_at_floor(double size) {
  Vector const from = knots_.back();
  double const s = depths_.back();
  double const scale = density_ * sound_speed_ * sound_speed_;
  double const floor = state(stepped(from, s, size), s + size).pressure / scale;
  double const part = bisect([&](double h) { return stepped(from, s, h)[2] - floor; }, 0.0, size);
  knots_.push_back(stepped(from, s, part));
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
  Vector const& from = knots_[next - 1];
  double const s = depths_[next - 1];
  double const size = bisect([&](double h) { return excess(state(stepped(from, s, h), s + h)); },
                             0.0, depths_[next] - s);
  return state(stepped(from, s, size), s + size);
}

IsentropeState Isentrope::at_pressure(double p) const {
  return where([p](IsentropeState const& at) { return at.pressure - p; });
}

bool Isentrope::spreads(IsentropeState const& last) const {
  auto const speed = [](IsentropeState const& at) { return at.sound_speed - at.velocity_change; };
  double const slack = 1e-9 * sound_speed_;  // of rounding
  for (std::size_t k = 1; k < states_.size() && states_[k].density >= last.density; ++k)
    if (speed(states_[k]) > speed(states_[k - 1]) + slack) return false;
  return true;
}

}  // namespace moraine
