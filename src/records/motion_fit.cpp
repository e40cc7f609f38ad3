#include "records/motion_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "records/spectral_measures.hpp"

namespace moraine {
namespace {

constexpr std::array<double, 4> layer_dampings{0.3, 0.15, 0.5, 0.8};
constexpr double lowest_corner = 0.02;  // Hz
constexpr int layers_tried = 12;
constexpr double looked_at_closely = 0.08;  // relative error of a rough period

void check(MotionTarget const& target) {
  for (double const value : {target.peak_acceleration, target.velocity_ratio,
                             target.predominant_period, target.duration, target.time_step})
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument("synthetic motion: all targets must be positive");
  if (target.time_step > 0.1 * target.predominant_period)
    throw std::invalid_argument(
        "synthetic motion: the time step must be at most a tenth of the predominant period");
  if (target.duration < 10.0 * target.predominant_period)
    throw std::invalid_argument(
        "synthetic motion: the duration must be at least ten predominant periods");
}

double velocity_ratio_of(GroundRecord const& record) {
  return peak_of(record, integrate(record).velocity).value /
         peak_of(record, record.acceleration).value;
}

/// Motions of one sequence of noise.
class Realisation {
 public:
  Realisation(MotionTarget const& target, std::uint64_t seed)
      : target_(target),
        noise_(white_noise(
            static_cast<std::size_t>(std::lround(target.duration / target.time_step)) + 1, seed)) {}

  /// The motion of a layer whose corner frequency brings PGV/PGA as near as it gets.
  FittedMotion fit_corner(double ground_frequency, double ground_damping) const {
    NoiseFilter filter{ground_frequency, ground_damping, lowest_corner, 0.6};
    auto const excess = [&](double corner) {
      filter.corner_frequency = corner;
      return velocity_ratio_of(motion(filter)) - target_.velocity_ratio;
    };
    double low = lowest_corner, high = ground_frequency;
    if (excess(low) > 0.0 && excess(high) < 0.0)
      while (high - low > 1e-4 * high) {
        double const middle = std::sqrt(low * high);
        (excess(middle) > 0.0 ? low : high) = middle;
      }
    else
      high = excess(high) >= 0.0 ? high : low;
    filter.corner_frequency = high;
    return finished(filter);
  }

 private:
  GroundRecord motion(NoiseFilter const& filter) const {
    return filtered_noise(noise_, target_.time_step, filter, target_.envelope,
                          target_.peak_acceleration);
  }

  FittedMotion finished(NoiseFilter const& filter) const {
    FittedMotion fit;
    fit.record = motion(filter);
    fit.filter = filter;
    fit.peak_acceleration = peak_of(fit.record, fit.record.acceleration).value;
    fit.velocity_ratio = velocity_ratio_of(fit.record);
    fit.predominant_period = rough_predominant_period(fit.record, target_.predominant_period);
    if (std::fabs(fit.predominant_period / target_.predominant_period - 1.0) < looked_at_closely)
      fit.predominant_period = predominant_period(fit.record);
    return fit;
  }

  MotionTarget const& target_;
  std::vector<double> noise_;
};

/// Keeps the better of what it has and what it is given.
class Best {
 public:
  explicit Best(MotionTarget const& target) : target_(target) {}
  void consider(FittedMotion fit) {
    double const error = fit.error(target_);
    if (given_ && error >= error_) return;
    fit_ = std::move(fit);
    error_ = error;
    given_ = true;
  }
  bool close() const { return given_ && error_ <= close_enough; }
  FittedMotion take() { return std::move(fit_); }

 private:
  MotionTarget const& target_;
  FittedMotion fit_;
  double error_ = 0.0;
  bool given_ = false;
};

/// Layers around the predominant period; where two next to each other have it between them, halving.
void search_layers(Realisation const& noise, double damping, MotionTarget const& target,
                   int realisation, Best& best) {
  double const wanted = 1.0 / target.predominant_period;
  auto const period_of = [&](double frequency) {
    FittedMotion fit = noise.fit_corner(frequency, damping);
    fit.realisation = realisation;
    double const period = fit.predominant_period;
    best.consider(std::move(fit));
    return period;
  };
  double before = 0.0, before_period = 0.0;
  for (int k = 0; k < layers_tried && !best.close(); ++k) {
    double const frequency = wanted * 0.5 * std::pow(4.0, k / (layers_tried - 1.0));
    double const period = period_of(frequency);
    double low = before, high = frequency;
    bool const between = k > 0 && (before_period - target.predominant_period) *
                                          (period - target.predominant_period) <
                                      0.0;
    bool const falls = before_period > period;
    for (int halving = 0; between && halving < 8 && !best.close(); ++halving) {
      double const middle = std::sqrt(low * high);
      ((period_of(middle) > target.predominant_period) == falls ? low : high) = middle;
    }
    before = frequency;
    before_period = period;
  }
}

}  // namespace

double FittedMotion::error(MotionTarget const& target) const {
  return std::max(std::fabs(velocity_ratio / target.velocity_ratio - 1.0),
                  std::fabs(predominant_period / target.predominant_period - 1.0));
}

FittedMotion fit_motion(MotionTarget const& target, std::uint64_t seed) {
  check(target);
  Best best(target);
  for (int k = 0; k < realisations && !best.close(); ++k) {
    // Seeds of the sequences lie far apart, so that those of neighbouring seeds do not meet.
    Realisation const noise(target, seed + 0x9E3779B97F4A7C15U * static_cast<std::uint64_t>(k));
    for (double const damping : layer_dampings)
      if (!best.close()) search_layers(noise, damping, target, k + 1, best);
  }
  FittedMotion fit = best.take();
  fit.predominant_period = predominant_period(fit.record);
  return fit;
}

}  // namespace moraine
