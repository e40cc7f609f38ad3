#include "records/motion_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "records/spectral_measures.hpp"

namespace moraine {
namespace {

constexpr std::array<double, 3> layer_frequencies{1.0, 0.7, 1.4};  // times the period
constexpr std::array<double, 3> layer_dampings{0.3, 0.15, 0.6};
constexpr double lowest_corner = 0.02;  // Hz
constexpr int stretches_tried = 6;
constexpr double least_stretch = 0.4;
constexpr double looked_at_closely = 0.08;  // relative error of a rough period

void check(MotionTarget const& target) {
  for (double const value : {target.peak_acceleration, target.velocity_ratio,
                             target.predominant_period, target.duration, target.time_step})
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument("synthetic motion: all targets must be positive");
  if (target.time_step > 0.1 * target.predominant_period)
    throw std::invalid_argument(
        "synthetic motion: the time step must be at most a tenth of the predominant period");
  if (!(target.duration / target.time_step < 1e7))
    throw std::invalid_argument("synthetic motion: more than ten million steps");
  if (target.duration < 10.0 * target.predominant_period)
    throw std::invalid_argument(
        "synthetic motion: the duration must be at least ten predominant periods");
}

double velocity_ratio_of(GroundRecord const& record) {
  return peak_of(record, integrate(record).velocity).value /
         peak_of(record, record.acceleration).value;
}

/// A layer in units of the predominant period, stretched in time.
struct Layer {
  double frequency;      // times the wanted period
  double damping;        // -
  double stretch = 1.0;  // of noise and layer
};

/// Motions of one sequence of noise.
class Realisation {
 public:
  Realisation(MotionTarget const& target, std::uint64_t seed, int number)
      : target_(target),
        number_(number),
        noise_(white_noise(static_cast<std::size_t>(
                               std::ceil(target.duration / target.time_step / least_stretch)) +
                               2,
                           seed)) {}

  /// The motion of a layer whose corner frequency brings PGV/PGA as near as it gets.
  FittedMotion fit_corner(Layer const& layer) const {
    NoiseMotion motion = motion_of(layer);
    auto const excess = [&](double corner) {
      motion.filter.corner_frequency = corner;
      return velocity_ratio_of(filtered_noise(noise_, motion)) - target_.velocity_ratio;
    };
    double low = lowest_corner, high = motion.filter.ground_frequency;
    if (excess(low) > 0.0 && excess(high) < 0.0)
      while (high - low > 1e-4 * high) {
        double const middle = std::sqrt(low * high);
        (excess(middle) > 0.0 ? low : high) = middle;
      }
    else
      high = excess(high) >= 0.0 ? high : low;
    motion.filter.corner_frequency = high;
    return finished(motion);
  }

 private:
  NoiseMotion motion_of(Layer const& layer) const {
    NoiseMotion motion{target_.duration,
                       target_.time_step,
                       target_.time_step * layer.stretch,
                       target_.peak_acceleration,
                       {},
                       target_.envelope};
    motion.filter.ground_frequency = layer.frequency / (target_.predominant_period * layer.stretch);
    motion.filter.ground_damping = layer.damping;
    return motion;
  }

  FittedMotion finished(NoiseMotion const& motion) const {
    FittedMotion fit;
    fit.record = filtered_noise(noise_, motion);
    fit.filter = motion.filter;
    fit.realisation = number_;
    fit.peak_acceleration = peak_of(fit.record, fit.record.acceleration).value;
    fit.velocity_ratio = velocity_ratio_of(fit.record);
    double const wanted = target_.predominant_period;
    fit.predominant_period = rough_predominant_period(fit.record, wanted);
    if (std::fabs(fit.predominant_period / wanted - 1.0) < looked_at_closely)
      fit.predominant_period = predominant_period(fit.record);
    return fit;
  }

  MotionTarget const& target_;
  int number_;
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

/// Stretches the layer until the predominant period is met, or its way is lost.
void stretch_to_period(Realisation const& noise, Layer layer, MotionTarget const& target,
                       Best& best) {
  for (int k = 0; k < stretches_tried && !best.close(); ++k) {
    FittedMotion fit = noise.fit_corner(layer);
    layer.stretch *= target.predominant_period / fit.predominant_period;
    bool const lost = std::fabs(fit.velocity_ratio / target.velocity_ratio - 1.0) > close_enough ||
                      layer.stretch < least_stretch || layer.stretch > 1.0 / least_stretch;
    best.consider(std::move(fit));
    if (lost) return;
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
    Realisation const noise(target, seed + 0x9E3779B97F4A7C15U * static_cast<std::uint64_t>(k),
                            k + 1);
    for (double const damping : layer_dampings)
      for (double const frequency : layer_frequencies)
        if (!best.close()) stretch_to_period(noise, {frequency, damping}, target, best);
  }
  FittedMotion fit = best.take();
  fit.predominant_period = predominant_period(fit.record);
  return fit;
}

}  // namespace moraine
