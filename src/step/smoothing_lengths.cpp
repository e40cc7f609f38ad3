#include "step/smoothing_lengths.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.hpp"
#include "step/simulation.hpp"

namespace moraine {

double smoothing_of_density(Model const& model, double mass, double density) {
  double const volume = mass / density;
  double const width = model.dimension == 1
                           ? volume
                           : (model.dimension == 2 ? std::sqrt(volume) : std::cbrt(volume));
  return model.numerics.smoothing_factor * width;
}

/// Every particle starts with what its density asks for.
void Simulation::begin_smoothing() {
  if (!model_.numerics.smoothing.varies()) return;
  ParticleStore& store = model_.particles;
  store.use(Field::smoothing_length);
  auto h = store.scalar(Field::smoothing_length);
  for (std::size_t i = 0; i < h.size(); ++i)
    h[i] =
        smoothing_of_density(model_, store.scalar(Field::mass)[i], store.scalar(Field::density)[i]);
  clip_smoothing();
}

/// From the rates of the last state to the density predicted for the next one: lists and pairs of
/// the next rates are those of the new lengths.
void Simulation::follow_density() {
  Smoothing const& smoothing = model_.numerics.smoothing;
  if (!smoothing.varies()) return;
  ParticleStore& store = model_.particles;
  auto h = store.scalar(Field::smoothing_length);
  auto const density = store.scalar(Field::density);  // half a step ahead, where it is a state
  auto const rate = store.scalar(Field::density_rate);
  auto const mass = store.scalar(Field::mass);
  double const dt = vote_.time_step;
  double const to_come = density_is_state() ? 0.5 * dt : dt;
  double const inverse_d = 1.0 / model_.dimension;
  for_each_block(h.size(), loop_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (smoothing.mode == SmoothingMode::rate)
        h[i] -= smoothing.rate_share * dt * h[i] * inverse_d * rate[i] / density[i];
      else
        h[i] = smoothing_of_density(model_, mass[i], density[i] + to_come * rate[i]);
    }
  });
  clip_smoothing();
}

void Simulation::clip_smoothing() {
  auto h = model_.particles.scalar(Field::smoothing_length);
  Smoothing const& smoothing = model_.numerics.smoothing;
  double const least = smoothing.least * model_.numerics.smoothing_length();
  double const most = smoothing.most * model_.numerics.smoothing_length();
  auto const clip = [&](std::size_t begin, std::size_t end) {
    SmoothingClips clips;
    for (std::size_t i = begin; i < end; ++i) {
      clips.at_least += h[i] < least ? 1 : 0;
      clips.at_most += h[i] > most ? 1 : 0;
      if (!(h[i] > least)) h[i] = least;  // also where a density is no number: the guards see it
      if (h[i] > most) h[i] = most;
    }
    return clips;
  };
  SmoothingClips const now = reduce_blocks(
      h.size(), SmoothingClips{}, clip, [](SmoothingClips a, SmoothingClips const& b) {
        return SmoothingClips{a.at_least + b.at_least, a.at_most + b.at_most};
      });
  smoothing_clips_.at_least = std::max(smoothing_clips_.at_least, now.at_least);
  smoothing_clips_.at_most = std::max(smoothing_clips_.at_most, now.at_most);
}

}  // namespace moraine
