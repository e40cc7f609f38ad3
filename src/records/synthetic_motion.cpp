#include "records/synthetic_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <utility>

#include "records/baseline.hpp"
#include "records/oscillator.hpp"

namespace moraine {
namespace {

enum class Output { absolute, relative };

/// The acceleration of an oscillator's mass under the input, in its place.
void pass_through(std::vector<double>& values, double frequency, double damping, double time_step,
                  Output output) {
  Oscillator const oscillator(2.0 * std::numbers::pi * frequency, damping, time_step);
  OscillatorState state;
  double before = values.front();
  for (std::size_t i = 0; i < values.size(); ++i) {
    double const ground = values[i];
    if (i > 0) state = oscillator.advance(state, before, ground);
    before = ground;
    values[i] = output == Output::absolute ? oscillator.absolute_acceleration(state)
                                           : oscillator.relative_acceleration(state, ground);
  }
}

/// `count` values at places 0, r, 2 r, ... between the numbers of the noise.
std::vector<double> on_steps(std::vector<double> const& noise, double r, std::size_t count) {
  if (!(r > 0.0) ||
      !(r * static_cast<double>(count - 1) <= static_cast<double>(noise.size()) - 1.0))
    throw std::invalid_argument("noise: there are too few numbers for the duration");
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    double const place = r * static_cast<double>(i);
    auto const k = std::min(noise.size() - 2, static_cast<std::size_t>(place));
    values[i] = noise[k] + (place - static_cast<double>(k)) * (noise[k + 1] - noise[k]);
  }
  return values;
}

}  // namespace

double Envelope::at(double part) const {
  if (part <= 0.0 || part > 1.0) return 0.0;
  if (part < rise) return part * part / (rise * rise);
  if (part <= stay) return 1.0;
  return std::exp(-std::log(20.0) * (part - stay) / (1.0 - stay));
}

std::vector<double> white_noise(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  // 53 random bits in (0, 1].
  auto const uniform = [&] { return (static_cast<double>(generator() >> 11) + 1.0) * 0x1p-53; };
  std::vector<double> noise;
  noise.reserve(count + 1);
  while (noise.size() < count) {
    double const radius = std::sqrt(-2.0 * std::log(uniform()));
    double const angle = 2.0 * std::numbers::pi * uniform();
    noise.push_back(radius * std::cos(angle));
    noise.push_back(radius * std::sin(angle));
  }
  noise.resize(count);
  return noise;
}

GroundRecord filtered_noise(std::vector<double> const& noise, NoiseMotion const& motion) {
  Envelope const& envelope = motion.envelope;
  if (!(0.0 < envelope.rise && envelope.rise <= envelope.stay && envelope.stay < 1.0))
    throw std::invalid_argument("envelope: it must rise, stay and fall between 0 and 1");
  double const steps = std::round(motion.duration / motion.time_step);
  if (!(steps >= 2.0 && steps < 1e8))
    throw std::invalid_argument("noise: the duration must be two steps or more");
  auto const count = static_cast<std::size_t>(steps) + 1;
  GroundRecord record{"synthetic", motion.time_step, 0.0,
                      on_steps(noise, motion.time_step / motion.noise_step, count)};
  check_record(record);
  NoiseFilter const& filter = motion.filter;
  std::vector<double>& a = record.acceleration;
  pass_through(a, filter.ground_frequency, filter.ground_damping, motion.time_step,
               Output::absolute);
  for (std::size_t i = 0; i < count; ++i) a[i] *= envelope.at(static_cast<double>(i) / steps);
  pass_through(a, filter.corner_frequency, filter.corner_damping, motion.time_step,
               Output::relative);
  return scaled_to_peak(baseline_corrected(std::move(record), Baseline::rest), motion.peak);
}

}  // namespace moraine
