#include "verify/wave_decay.hpp"

#include <cmath>
#include <vector>

#include "exact/standing_wave.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

/// The wave of a case; its amplitude does not matter.
StandingWave exact_of(Case const& c) {
  MaterialSpec const& liquid = c.materials.front();
  StandingWave wave;
  wave.wave_length = 2.0 * (c.domain.max[0] - c.domain.min[0]);
  wave.depth = *c.regions.front().initial.hydrostatic_level;
  wave.gravity = -c.gravity[1];
  wave.density = reference_density(liquid.eos);
  wave.kinematic_viscosity = liquid.dynamic_viscosity / wave.density;
  return wave;
}

/// How much of the wave's mode is in the velocities, in units of those of `wave` a quarter of a
/// period before its crest.
double amplitude(Simulation const& simulation, StandingWave const& wave) {
  ParticleStore const& store = simulation.particles();
  double const start = -0.25 * wave.period();
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    auto const mode = wave.sample(store.component(Field::position, 0)[i],
                                  store.component(Field::position, 1)[i] - wave.depth, start);
    product += store.component(Field::velocity, 0)[i] * mode.velocity_x +
               store.component(Field::velocity, 1)[i] * mode.velocity_z;
    square += mode.velocity_x * mode.velocity_x + mode.velocity_z * mode.velocity_z;
  }
  return product / square;
}

struct Instant {
  double time = 0.0;  // s
  double value = 0.0;
};

/// The vertex of the parabola through three instants.
Instant vertex(Instant const& a, Instant const& b, Instant const& c) {
  double const first = (b.value - a.value) / (b.time - a.time);
  double const second = (c.value - b.value) / (c.time - b.time);
  double const bend = (second - first) / (c.time - a.time);
  double const time = 0.5 * (a.time + b.time) - 0.5 * first / bend;
  return {time, b.value - bend * (b.time - time) * (b.time - time)};
}

/// Zeros and extrema of a swing that is told instant by instant.
class Swing {
 public:
  explicit Swing(double half_period) : half_period_(half_period) {}

  void add(Instant const& now) {
    if (count_ > 0 && (now.value > 0.0) != (last_.value > 0.0))
      zeros_.push_back(last_.time +
                       (now.time - last_.time) * last_.value / (last_.value - now.value));
    bool const turns = count_ > 1 && std::fabs(last_.value) > std::fabs(now.value) &&
                       std::fabs(last_.value) >= std::fabs(before_.value);
    // Ripples on top of an extremum are not the next one.
    if (turns && last_.time > last_extremum_.time + 0.7 * half_period_)
      last_extremum_ = vertex(before_, last_, now);
    if (count_ == 0) first_ = now;
    before_ = last_;
    last_ = now;
    ++count_;
  }

  double period() const {
    auto const halves = static_cast<double>(zeros_.size()) - 1.0;
    return 2.0 * (zeros_.back() - zeros_.front()) / halves;
  }

  /// Of the logarithm of the amplitude [1/s].
  double decay() const {
    return std::log(std::fabs(first_.value / last_extremum_.value)) /
           (last_extremum_.time - first_.time);
  }

 private:
  double half_period_;  // s, expected
  Instant first_, before_, last_, last_extremum_;
  std::vector<double> zeros_;  // s
  int count_ = 0;
};

}  // namespace

WaveRun run_wave(Case const& c, int periods) {
  StandingWave const wave = exact_of(c);
  Case timed = c;
  timed.time.end = (periods + 0.1) * wave.period();
  Simulation simulation(build_model(timed));
  ConservedSums const before = simulation.sums();
  Swing swing(0.5 * wave.period());
  swing.add({0.0, amplitude(simulation, wave)});
  while (simulation.running()) {
    simulation.advance();
    swing.add({simulation.time(), amplitude(simulation, wave)});
  }
  WaveRun run;
  run.period = swing.period() / wave.period() - 1.0;
  run.loss = swing.decay() * wave.period();
  run.energy_drift =
      (simulation.sums().total_energy() - before.total_energy()) / before.kinetic_energy;
  run.steps = simulation.step();
  return run;
}

double exact_wave_loss(Case const& c) {
  StandingWave const wave = exact_of(c);
  return wave.decay_rate() * wave.period();
}

}  // namespace moraine
