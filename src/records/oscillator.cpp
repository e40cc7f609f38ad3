#include "records/oscillator.hpp"

#include <cmath>
#include <stdexcept>

namespace moraine {
namespace {

using Matrix = std::array<double, 4>;  // rows one after the other

constexpr Matrix identity{1.0, 0.0, 0.0, 1.0};

Matrix product(Matrix const& a, Matrix const& b) {
  return {a[0] * b[0] + a[1] * b[2], a[0] * b[1] + a[1] * b[3], a[2] * b[0] + a[3] * b[2],
          a[2] * b[1] + a[3] * b[3]};
}

Matrix combined(Matrix const& a, double factor, Matrix const& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2], a[3] + factor * b[3]};
}

/// sum_j x^j / (j + k)!, for a matrix whose eigenvalues are below 1/2: 18 terms reach 1e-20.
Matrix series(Matrix const& x, int k) {
  double factorial = 1.0;
  for (int j = 2; j <= k; ++j) factorial *= j;
  Matrix power = identity, sum{};
  for (int j = 0; j < 18; ++j) {
    sum = combined(sum, 1.0 / factorial, power);
    power = product(power, x);
    factorial *= j + k + 1;
  }
  return sum;
}

Matrix exponential(double w, double zeta, double dt) {
  double const root = std::sqrt(1.0 - zeta * zeta);
  double const decay = std::exp(-zeta * w * dt);
  double const s = decay * std::sin(w * root * dt), c = decay * std::cos(w * root * dt);
  return {c + zeta / root * s, s / (w * root), -w / root * s, c - zeta / root * s};
}

struct StepMatrices {
  Matrix phi, phi_1, phi_2;
};

StepMatrices step_matrices(double w, double zeta, double dt) {
  if (w * dt < 0.5) {
    Matrix const x{0.0, dt, -w * w * dt, -2.0 * zeta * w * dt};
    return {series(x, 0), series(x, 1), series(x, 2)};
  }
  Matrix const inverse{-2.0 * zeta / (w * dt), -1.0 / (w * w * dt), 1.0 / dt, 0.0};
  Matrix const phi = exponential(w, zeta, dt);
  Matrix const phi_1 = product(combined(phi, -1.0, identity), inverse);
  return {phi, phi_1, product(combined(phi_1, -1.0, identity), inverse)};
}

}  // namespace

Oscillator::Oscillator(double angular_frequency, double damping_ratio, double time_step)
    : friction_(2.0 * damping_ratio * angular_frequency),
      stiffness_(angular_frequency * angular_frequency) {
  if (!(angular_frequency > 0.0 && time_step > 0.0 && std::isfinite(angular_frequency * time_step)))
    throw std::invalid_argument("oscillator: frequency and time step must be positive");
  if (!(damping_ratio >= 0.0 && damping_ratio < 1.0))
    throw std::invalid_argument("oscillator: the damping ratio must be at least 0 and below 1");
  StepMatrices const m = step_matrices(angular_frequency, damping_ratio, time_step);
  phi_ = m.phi;
  for (std::size_t row = 0; row < 2; ++row) {  // b picks the second column, with a minus
    after_[row] = -time_step * m.phi_2[2 * row + 1];
    before_[row] = -time_step * (m.phi_1[2 * row + 1] - m.phi_2[2 * row + 1]);
  }
}

}  // namespace moraine
