#include "records/measures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "base/gravity.hpp"
#include "records/spectral_measures.hpp"

namespace moraine {
namespace {

constexpr double g = standard_gravity;

double squared(double x) { return x * x; }

/// int f(value) dt by the trapezoidal rule.
template <class F>
double integral(std::vector<double> const& values, double dt, F const& f) {
  double sum = -0.5 * (f(values.front()) + f(values.back()));
  for (double const value : values) sum += f(value);
  return sum * dt;
}

/// Magnitudes of the half-cycles between zeros.
std::vector<double> half_cycles(std::vector<double> const& values) {
  std::vector<double> peaks;
  double side = 0.0;
  for (double const value : values) {
    if (value == 0.0) continue;
    if (value * side <= 0.0) peaks.push_back(0.0);
    side = value;
    peaks.back() = std::max(peaks.back(), std::fabs(value));
  }
  return peaks;
}

}  // namespace

double arias_intensity(GroundRecord const& record) {
  return 0.5 * std::numbers::pi / g * integral(record.acceleration, record.time_step, squared);
}

double characteristic_intensity(double rms_in_g, double duration) {
  return std::pow(rms_in_g, 1.5) * std::sqrt(duration);
}

double duration_of(double arias, double rms_in_g) {
  return 2.0 * arias / (std::numbers::pi * g * rms_in_g * rms_in_g);
}

double cumulative_absolute_velocity(GroundRecord const& record) {
  return integral(record.acceleration, record.time_step, [](double a) { return std::fabs(a); });
}

double sustained_maximum(std::vector<double> const& values) {
  std::vector<double> peaks = half_cycles(values);
  if (peaks.empty()) return 0.0;
  std::sort(peaks.begin(), peaks.end(), std::greater<>());
  return peaks[std::min<std::size_t>(2, peaks.size() - 1)];
}

double a95(GroundRecord const& record) {
  std::vector<double> sizes;
  for (double const a : record.acceleration) sizes.push_back(std::fabs(a));
  std::sort(sizes.begin(), sizes.end());
  double const all = std::inner_product(sizes.begin(), sizes.end(), sizes.begin(), 0.0);
  double sum = 0.0;
  for (double const size : sizes) {
    sum += size * size;
    if (sum >= 0.95 * all) return size;
  }
  return sizes.back();
}

TimeSpan significant_duration(GroundRecord const& record) {
  std::vector<double> const& a = record.acceleration;
  double const all = integral(a, 1.0, squared);
  auto const when = [&](double part) {
    double sum = 0.0;
    for (std::size_t i = 1; i < a.size(); ++i) {
      double const next = sum + 0.5 * (squared(a[i - 1]) + squared(a[i]));
      if (next >= part * all && next > sum)
        return record.time(i - 1) + (part * all - sum) / (next - sum) * record.time_step;
      sum = next;
    }
    return record.time(a.size() - 1);
  };
  return {when(0.05), when(0.95)};
}

TimeSpan bracketed_duration(GroundRecord const& record, double threshold) {
  std::vector<double> const& a = record.acceleration;
  auto const above = [&](double value) { return std::fabs(value) > threshold; };
  auto const first = std::find_if(a.begin(), a.end(), above);
  if (first == a.end()) return {};
  auto const last = std::find_if(a.rbegin(), a.rend(), above);
  // Where the line from `inside` to its neighbour leaves the threshold, in steps.
  auto const crossing = [&](double inside, double outside) {
    return (std::fabs(inside) - threshold) / std::fabs(inside - outside);
  };
  double from = record.time(static_cast<std::size_t>(first - a.begin()));
  double to = record.time(static_cast<std::size_t>(a.rend() - last) - 1);
  if (first != a.begin()) from -= record.time_step * crossing(*first, *(first - 1));
  if (last != a.rbegin()) to += record.time_step * crossing(*last, *(last - 1));
  return {from, to};
}

MotionMeasures measure(GroundRecord const& record) {
  check_record(record);
  Peak const peak = peak_of(record, record.acceleration);
  if (peak.value == 0.0) throw std::invalid_argument("measures: the record is zero throughout");
  if (record.time_step > coarsest_measured_step * (1.0 + 1e-9))
    throw std::invalid_argument("measures: the time step is too coarse for spectra from 0.1 s");
  GroundPath const path = integrate(record);
  SpectrumIntensities const spectra = spectrum_intensities(record);
  MotionMeasures m{};
  m.acceleration = peak;
  m.velocity = peak_of(record, path.velocity);
  m.displacement = peak_of(record, path.displacement);
  m.duration = record.duration();
  m.rms_acceleration =
      std::sqrt(integral(record.acceleration, record.time_step, squared) / m.duration);
  m.arias_intensity = arias_intensity(record);
  m.characteristic_intensity = characteristic_intensity(m.rms_acceleration / g, m.duration);
  m.cumulative_velocity = cumulative_absolute_velocity(record);
  m.specific_energy_density = integral(path.velocity, record.time_step, squared);
  m.velocity_intensity = spectra.velocity;
  m.housner_intensity = spectra.pseudo_velocity;
  m.acceleration_intensity = spectra.acceleration;
  m.design_acceleration = effective_design_acceleration(record);
  m.predominant_period = predominant_period(record);
  m.sustained_acceleration = sustained_maximum(record.acceleration);
  m.sustained_velocity = sustained_maximum(path.velocity);
  m.a95 = a95(record);
  m.significant = significant_duration(record);
  m.bracketed = bracketed_duration(record, 0.05 * g);
  return m;
}

}  // namespace moraine
