#include "records/synthetic_motion.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

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
  auto const uniform = [&] {
    return (static_cast<double>(generator() >> 11) + 1.0) * 0x1p-53;
  };
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

GroundRecord filtered_noise(std::vector<double> const& noise, double time_step,
                            NoiseFilter const& filter, Envelope const& envelope, double peak) {
  if (!(0.0 < envelope.rise && envelope.rise <= envelope.stay && envelope.stay < 1.0))
    throw std::invalid_argument("envelope: it must rise, stay and fall between 0 and 1");
  GroundRecord record{"synthetic", time_step, 0.0, noise};
  check_record(record);
  std::vector<double>& a = record.acceleration;
  pass_through(a, filter.ground_frequency, filter.ground_damping, time_step, Output::absolute);
  auto const last = static_cast<double>(a.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] *= envelope.at(static_cast<double>(i) / last);
  pass_through(a, filter.corner_frequency, filter.corner_damping, time_step, Output::relative);
  return scaled_to_peak(baseline_corrected(std::move(record), Baseline::rest), peak);
}

}  // namespace moraine
