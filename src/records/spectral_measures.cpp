#include "records/spectral_measures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "records/butterworth.hpp"
#include "records/response_spectrum.hpp"

namespace moraine {
namespace {

constexpr double usual_damping = 0.05;
constexpr double period_step = 0.01;  // s, of integrals over periods

/// Where a function of one variable is largest between `low` and `high`: golden section, for one
/// maximum inside.
double maximize(std::function<double(double)> const& f, double low, double high) {
  constexpr double golden = 1.0 / std::numbers::phi;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double f_a = f(a), f_b = f(b);
  while (high - low > 1e-4 * high) {
    if (f_a < f_b) {
      low = std::exchange(a, b);
      f_a = f_b;
      b = low + golden * (high - low);
      f_b = f(b);
    } else {
      high = std::exchange(b, a);
      f_b = f_a;
      a = high - golden * (high - low);
      f_a = f(a);
    }
  }
  return 0.5 * (low + high);
}

/// Periods at equal ratios of about 1 + `part`.
std::vector<double> periods_between(double first, double last, double part) {
  return periods_at_equal_ratios(first, last,
                                 static_cast<std::size_t>(std::log(last / first) / part) + 2);
}

std::size_t place_of_largest(std::vector<double> const& periods,
                             std::function<double(double)> const& f) {
  std::size_t best = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < periods.size(); ++k)
    if (double const found = f(periods[k]); found > largest) {
      largest = found;
      best = k;
    }
  return best;
}

}  // namespace

SpectrumIntensities spectrum_intensities(GroundRecord const& record) {
  constexpr int first = 10, last_of_acceleration = 50, last = 250;  // period steps
  SpectrumIntensities result;
  for (int k = first; k <= last; ++k) {
    SpectralResponse const r = spectral_response(record, k * period_step, usual_damping);
    double const weight = (k == first || k == last ? 0.5 : 1.0) * period_step;
    result.velocity += weight * r.velocity;
    result.pseudo_velocity += weight * r.pseudo_velocity;
    if (k > last_of_acceleration) continue;
    double const share = (k == first || k == last_of_acceleration ? 0.5 : 1.0) * period_step;
    result.acceleration += share * r.pseudo_acceleration;
  }
  return result;
}

double shortest_predominant_period(double time_step) {
  return std::max(0.02, shortest_period(time_step));
}

double predominant_period(GroundRecord const& record) {
  double const first = shortest_predominant_period(record.time_step);
  double const last = longest_predominant_period;
  if (!(first < last))
    throw std::invalid_argument("predominant period: the time step is too coarse");
  std::vector<double> const periods = periods_between(first, last, 0.01);
  auto const answer = [&](double period) {
    return spectral_response(record, period, usual_damping).pseudo_acceleration;
  };
  std::size_t const best = place_of_largest(periods, answer);
  return maximize(answer, periods[best > 0 ? best - 1 : 0],
                  periods[std::min(periods.size() - 1, best + 1)]);
}

double rough_predominant_period(GroundRecord const& record, double about) {
  std::vector<double> const periods =
      periods_between(std::max(0.25 * about, shortest_period(record.time_step)), 4.0 * about, 0.04);
  return periods[place_of_largest(periods, [&](double period) {
    return spectral_response(record, period, usual_damping, 16.0).pseudo_acceleration;
  })];
}

double effective_design_acceleration(GroundRecord const& record) {
  GroundRecord const low = filtered(record, {Passband::low, 9.0, 2, Passes::both_ways});
  return peak_of(low, low.acceleration).value;
}

}  // namespace moraine
