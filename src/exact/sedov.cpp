#include "exact/sedov.hpp"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/bisect.hpp"

namespace moraine {
namespace {

void check(SedovBlast const& blast) {
  double const gamma = blast.heat_capacity_ratio;
  int const j = dimensions(blast.geometry);
  if (!(gamma > 1.0 && (j - 2) * gamma < 3.0 * j - 2.0))
    throw std::invalid_argument(
        "Sedov: the heat capacity ratio must be above 1, and below 7 for spheres");
  if (std::fabs(gamma - 2.0) < 1e-4)
    throw std::invalid_argument(
        "Sedov: the powers of the solution diverge at a heat capacity ratio of 2; keep 1e-4 away");
  if (!(blast.density > 0.0 && blast.energy > 0.0))
    throw std::invalid_argument("Sedov: density and energy must be positive");
}

}  // namespace

Sedov::Sedov(SedovBlast const& blast)
    : blast_(blast), gamma_(blast.heat_capacity_ratio), j_(dimensions(blast.geometry)) {
  check(blast);
  double const k = j_ + 2.0;
  a0_ = 2.0 / k;
  a2_ = -(gamma_ - 1.0) / (2.0 * (gamma_ - 1.0) + j_);
  a1_ = k * gamma_ / (2.0 + j_ * (gamma_ - 1.0)) *
        (2.0 * j_ * (2.0 - gamma_) / (gamma_ * k * k) - a2_);
  a3_ = j_ / (2.0 * (gamma_ - 1.0) + j_);
  a4_ = k * a1_ / (2.0 - gamma_);
  a5_ = -2.0 / (2.0 - gamma_);
  alpha_ = profile_energy();
}

Sedov::Logarithms Sedov::logarithms(double y) const {
  double const b = (gamma_ + 1.0) / (gamma_ - 1.0);
  double const growth = std::exp(y) / b;  // V/V_0 - 1
  double const d = (j_ + 2.0) * (gamma_ + 1.0);
  double const e = 2.0 + j_ * (gamma_ - 1.0);
  double const v = 2.0 / ((j_ + 2.0) * gamma_) * (1.0 + growth);
  return {std::log((1.0 + growth) * 0.5 * (gamma_ + 1.0) / gamma_), y,
          std::log(d / (d - 2.0 * e) * (1.0 - 0.5 * e * v)),
          std::log(b * (gamma_ - 1.0 - growth) / gamma_)};
}

double Sedov::log_lambda(Logarithms const& x) const {
  return -a0_ * x.x1 - a2_ * x.x2 - a1_ * x.x3;
}

Sedov::Profile Sedov::profile(double lambda) const {
  double const target = std::log(lambda);
  auto const excess = [&](double y) { return log_lambda(logarithms(y)) - target; };
  double low = std::min(-1.0, -target / a2_);
  while (excess(low) > 0.0) low *= 2.0;
  double const y = lambda < 1.0 ? bisect(excess, low, 0.0) : 0.0;
  Logarithms const x = logarithms(y);
  return {std::exp(x.x1) * lambda, std::exp(a3_ * x.x2 + a4_ * x.x3 + a5_ * x.x4),
          std::exp(a0_ * j_ * x.x1 + (a4_ - 2.0 * a1_) * x.x3 + (1.0 + a5_) * x.x4)};
}

double Sedov::profile_energy() const {
  boost::math::quadrature::tanh_sinh<double> integrator;
  // Over q = lambda^j, in which mass and energy are spread evenly around the origin.
  auto const energy = [this](double q) {
    Profile const at = profile(std::pow(q, 1.0 / j_));
    return at.g * at.f * at.f + at.h;
  };
  double const integral = integrator.integrate(energy, 0.0, 1.0, 1e-12) / j_;
  return unit_area(blast_.geometry) * a0_ * a0_ * 2.0 / (gamma_ * gamma_ - 1.0) * integral;
}

double Sedov::shock_position(double time) const {
  return std::pow(blast_.energy * time * time / (alpha_ * blast_.density), 0.5 * a0_);
}

double Sedov::shock_speed(double time) const { return a0_ * shock_position(time) / time; }

FlowState Sedov::behind_shock(double time) const {
  double const speed = shock_speed(time);
  double const rho = blast_.density * (gamma_ + 1.0) / (gamma_ - 1.0);
  double const p = 2.0 * blast_.density * speed * speed / (gamma_ + 1.0);
  return {rho, 2.0 * speed / (gamma_ + 1.0), p, p / ((gamma_ - 1.0) * rho)};
}

FlowState Sedov::sample(double r, double time) const {
  double const lambda = r / shock_position(time);
  if (lambda > 1.0) return {blast_.density, 0.0, 0.0, 0.0};
  FlowState const edge = behind_shock(time);
  // Below the smallest size of a number that keeps its digits all powers have reached their limits.
  Profile const at = profile(std::max(lambda, std::numeric_limits<double>::min()));
  FlowState state{edge.density * at.g, lambda > 0.0 ? edge.velocity * at.f : 0.0,
                  edge.pressure * at.h, 0.0};
  state.specific_energy = state.pressure / ((gamma_ - 1.0) * state.density);
  return state;
}

}  // namespace moraine
