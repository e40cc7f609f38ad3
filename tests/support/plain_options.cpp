#include "support/plain_options.hpp"

#include <algorithm>
#include <cmath>

#include "base/vec3.hpp"

namespace moraine {
namespace {

double rho(Model const& m, std::size_t i) { return m.particles.scalar(Field::density)[i]; }
double mass(Model const& m, std::size_t i) { return m.particles.scalar(Field::mass)[i]; }
double speed(Model const& m, std::size_t i, std::size_t a) {
  return m.particles.component(Field::velocity, static_cast<int>(a))[i];
}
double viscosity_of(Model const& m, std::size_t i) {
  return m.materials[m.particles.material()[i]].dynamic_viscosity;
}
std::size_t axes(Model const& m) { return static_cast<std::size_t>(m.dimension); }
double square(PlainPair const& p) { return p.x[0] * p.x[0] + p.x[1] * p.x[1] + p.x[2] * p.x[2]; }

}  // namespace

Rates plain_morris(Model const& m, std::size_t i) {
  Rates rates;
  for (PlainPair const& p : plain_pairs(m, i)) {
    double const factor = mass(m, p.j) * (viscosity_of(m, i) + viscosity_of(m, p.j)) /
                          (rho(m, i) * rho(m, p.j)) * p.gradient;
    for (std::size_t a = 0; a < axes(m); ++a) {
      double const v = speed(m, i, a) - speed(m, p.j, a);
      rates.acceleration[a] += factor * v;
      rates.energy_rate -= 0.5 * factor * v * v;
    }
  }
  return rates;
}

Rates plain_cleary(Model const& m, std::size_t i) {
  Rates rates;
  for (PlainPair const& p : plain_pairs(m, i)) {
    double const mu_i = viscosity_of(m, i), mu_j = viscosity_of(m, p.j);
    double const approach = plain_approach(m, i, p);
    double const pi = 2.0 * (m.dimension + 2) / (rho(m, i) * rho(m, p.j)) * 2.0 * mu_i * mu_j /
                      (mu_i + mu_j) * approach / square(p);
    for (std::size_t a = 0; a < axes(m); ++a)
      rates.acceleration[a] += mass(m, p.j) * pi * p.gradient * p.x[a];
    rates.energy_rate -= 0.5 * mass(m, p.j) * pi * p.gradient * approach;
  }
  return rates;
}

Rates plain_xsph(Model const& m, std::size_t i) {
  Rates rates;
  for (PlainPair const& p : plain_pairs(m, i))
    for (std::size_t a = 0; a < axes(m); ++a)
      rates.drift[a] += 0.5 * mass(m, p.j) / (0.5 * (rho(m, i) + rho(m, p.j))) *
                        (speed(m, p.j, a) - speed(m, i, a)) * p.kernel;
  return rates;
}

Rates plain_penalty(Model const& m, std::size_t i) {
  Rates rates;
  double const lambda = m.numerics.spacing / m.numerics.smoothing_length();
  for (PlainPair const& p : plain_pairs(m, i)) {
    if (m.particles.material()[i] == m.particles.material()[p.j]) continue;
    double const r = std::sqrt(square(p));
    double const pe = lambda * (plain_smoothing(m, i) + plain_smoothing(m, p.j)) / (2.0 * r);
    if (pe <= 1.0) continue;
    double const f = 2e3 * (std::pow(pe, 12) - std::pow(pe, 6)) / (r * r);
    for (std::size_t a = 0; a < axes(m); ++a) rates.acceleration[a] += f * p.x[a] / mass(m, i);
  }
  return rates;
}

namespace {

/// s (M^-1 - 1), with s from 1 to 0 while sqrt(d) / |M^-1| falls from 0.4 to 0.2.
Matrix plain_correction_of(Model const& m, std::size_t i, bool of_one_material) {
  Matrix k = inverse(plain_moments(m, i, of_one_material), m.dimension);
  double norm2 = 0.0;
  for (auto const& row : k)
    for (double const entry : row) norm2 += entry * entry;
  double const share = std::clamp((std::sqrt(m.dimension / norm2) - 0.2) / 0.2, 0.0, 1.0);
  for (std::size_t a = 0; a < axes(m); ++a)
    for (std::size_t b = 0; b < axes(m); ++b) k[a][b] = share * (k[a][b] - (a == b ? 1.0 : 0.0));
  return k;
}

std::array<double, 3> plain_gradient(Model const& m, std::size_t i) {
  std::array<double, 3> slope{};
  for (PlainPair const& p : plain_pairs(m, i)) {
    if (m.particles.material()[i] != m.particles.material()[p.j]) continue;
    for (std::size_t a = 0; a < axes(m); ++a)
      slope[a] += mass(m, p.j) / rho(m, p.j) * (rho(m, p.j) - rho(m, i)) * p.gradient * p.x[a];
  }
  Matrix const k = plain_correction_of(m, i, true);
  std::array<double, 3> gradient = slope;
  for (std::size_t a = 0; a < axes(m); ++a)
    for (std::size_t b = 0; b < axes(m); ++b) gradient[a] += k[a][b] * slope[b];
  return gradient;
}

}  // namespace

Rates plain_diffusion(Model const& m, std::size_t i) {
  Rates rates;
  auto const own = plain_gradient(m, i);
  auto const c = m.particles.scalar(Field::sound_speed);
  for (PlainPair const& p : plain_pairs(m, i)) {
    if (m.particles.material()[i] != m.particles.material()[p.j]) continue;
    auto const other = plain_gradient(m, p.j);
    double along = 0.0;
    for (std::size_t a = 0; a < axes(m); ++a) along += (own[a] + other[a]) * p.x[a] * p.gradient;
    rates.density_rate -= 0.1 * 0.5 * (c[i] + c[p.j]) * p.h * mass(m, p.j) /
                          (0.5 * (rho(m, i) + rho(m, p.j))) * along;
  }
  return rates;
}

namespace {

/// v_ij, that of walls at rest.
std::array<double, 3> velocity_of(Model const& m, std::size_t i, PlainPair const& p) {
  std::array<double, 3> v{};
  for (std::size_t a = 0; a < axes(m); ++a)
    v[a] = speed(m, i, a) - (p.wall ? 0.0 : speed(m, p.j, a));
  return v;
}

/// v as the continuity equation sees it: with free slip along the normal of the wall particle
/// alone, where it has one.
std::array<double, 3> seen_of(Model const& m, PlainPair const& p, std::array<double, 3> const& v) {
  if (!p.wall) return v;
  WallPoint const& point = m.walls.points[m.particles.id()[p.j] - m.walls.first_id];
  Vec3 const n = m.walls.normal(point);
  if (!point.free_slip || norm(n) == 0.0) return v;
  Vec3 const along = scale(dot({v[0], v[1], v[2]}, n), n);
  return {along[0], along[1], along[2]};
}

/// What stands before K_i grad W and K_j grad W: in the conservative form p / rho^2 of each, in the
/// mixed form p / (rho_i rho_j). A wall has K_j = 0, and a pressure that never pulls with that of
/// i.
std::array<double, 2> pressures_of(Model const& m, std::size_t i, PlainPair const& p) {
  auto const pressure = m.particles.scalar(Field::pressure);
  bool const mixed = m.numerics.momentum == MomentumForm::mixed;
  double const p_i = pressure[i] / rho(m, i) / rho(m, mixed ? p.j : i);
  double const p_j = pressure[p.j] / rho(m, p.j) / rho(m, mixed ? i : p.j);
  if (p.wall) return {std::max(p_i + p_j, 0.0), 0.0};
  return {p_i, p_j};
}

std::array<double, 3> turned(Matrix const& k, PlainPair const& p) {
  std::array<double, 3> turned{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) turned[a] += k[a][b] * p.x[b] * p.gradient;
  return turned;
}

}  // namespace

Rates plain_correction(Model const& m, std::size_t i) {
  Rates rates;
  bool const volume = m.numerics.continuity == ContinuityForm::volume;
  Matrix const k_i = plain_correction_of(m, i, false);
  for (PlainPair const& p : plain_pairs(m, i)) {
    auto const own = turned(k_i, p);
    auto const other = turned(p.wall ? Matrix{} : plain_correction_of(m, p.j, false), p);
    auto const [p_i, p_j] = pressures_of(m, i, p);
    auto const v = velocity_of(m, i, p);
    auto const seen = seen_of(m, p, v);
    double const weight =
        p.wall ? rho(m, p.j) * std::pow(m.numerics.spacing, m.dimension) : mass(m, p.j);
    for (std::size_t a = 0; a < axes(m); ++a) {
      double const push = p_i * own[a] + p_j * other[a];
      rates.acceleration[a] -= weight * push;
      rates.density_rate += weight * (volume ? rho(m, i) / rho(m, p.j) : 1.0) * seen[a] * own[a];
      rates.energy_rate += (p.wall ? 1.0 : 0.5) * weight * push * v[a];
    }
  }
  return rates;
}

Rates plain_shifting(Model const& m, std::size_t i) {
  Rates rates;
  std::array<double, 3> slope{};
  double size = 0.0, v2 = 0.0, divergence = 0.0;
  Matrix const moments = plain_moments(m, i, false);
  for (PlainPair const& p : plain_pairs(m, i)) {
    double pair_v2 = 0.0;
    for (std::size_t a = 0; a < axes(m); ++a) {
      slope[a] += mass(m, p.j) / rho(m, p.j) * p.gradient * p.x[a];
      pair_v2 += std::pow(speed(m, i, a) - speed(m, p.j, a), 2);
    }
    v2 = std::max(v2, pair_v2);
  }
  for (std::size_t a = 0; a < axes(m); ++a) {
    size += slope[a] * slope[a];
    divergence += moments[a][a];
  }
  double const inside = std::clamp((divergence / m.dimension - 0.75) / 0.2, 0.0, 1.0);
  double factor = 2.0 * plain_smoothing(m, i) * std::sqrt(v2) * inside;
  if (factor * std::sqrt(size) > 0.5 * std::sqrt(v2))
    factor = 0.5 * std::sqrt(v2) / std::sqrt(size);
  for (std::size_t a = 0; a < axes(m); ++a) rates.drift[a] = -factor * slope[a];
  return rates;
}

}  // namespace moraine
