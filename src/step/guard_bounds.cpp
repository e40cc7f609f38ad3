#include "step/guard_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "smoothing/kernel_names.hpp"
#include "step/bad_particles.hpp"

namespace moraine {

void StateRange::include(Model const& model) {
  ParticleStore const& store = model.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  auto const density = store.scalar(Field::density);
  auto const energy = store.scalar(Field::specific_energy);
  auto const sound_speed = store.scalar(Field::sound_speed);
  Components const velocity = components_of(store, Field::velocity);
  Components const position = components_of(store, Field::position);
  if (density_min.empty()) {
    for (Material const& material : model.materials)
      density_min.push_back(reference_density(material.eos));
    density_max = density_min;
  }
  bool const first = !any_;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t const m = store.material()[i];
    density_min[m] = std::min(density_min[m], density[i]);
    density_max[m] = std::max(density_max[m], density[i]);
    energy_min = any_ ? std::min(energy_min, energy[i]) : energy[i];
    energy_max = any_ ? std::max(energy_max, energy[i]) : energy[i];
    auto const& burn = model.materials[m].burn;
    double const front = burn ? burn->law.detonation_velocity : 0.0;
    signal_speed =
        std::max(signal_speed, std::sqrt(square_of(velocity, i)) + std::max(sound_speed[i], front));
    if (first) {
      double potential = 0.0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(model.dimension); ++k)
        potential -= model.gravity[k] * position[k][i];
      lowest_potential = any_ ? std::min(lowest_potential, potential) : potential;
    }
    any_ = true;
  }
}

void StateRange::exchange(Archive& archive) {
  archive.array("guards/density_min", "kg/m^3", density_min);
  archive.array("guards/density_max", "kg/m^3", density_max);
  archive.number("guards/energy_min", energy_min);
  archive.number("guards/energy_max", energy_max);
  archive.number("guards/signal_speed", signal_speed);
  archive.number("guards/lowest_potential", lowest_potential);
  any_ = true;  // nothing is saved before the start has been included
}

double fall_speed(Model const& model) {
  double half_square = 0.0;
  double endless = 0.0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(model.dimension); ++k) {
    double const g = std::fabs(model.gravity[k]);
    if (model.periodic[k])
      endless += g * model.time.end;
    else
      half_square += g * (model.domain_max[k] - model.domain_min[k]);
  }
  return std::sqrt(2.0 * half_square) + endless;
}

double largest_compression(Eos const& eos) {
  return std::holds_alternative<IdealGas>(eos) ? 1000.0 : 3.0;
}

double largest_expansion(Model const& model) {
  return 1000.0 * std::pow(kernel_support * model.numerics.smoothing_factor, model.dimension);
}

GuardBounds bounds_of(Model const& model, StateRange const& start) {
  GuardSettings const& settings = model.guards;
  GuardBounds bounds;
  double const expansion = settings.expansion.value_or(largest_expansion(model));
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    double const compression =
        settings.compression.value_or(largest_compression(model.materials[m].eos));
    bounds.density_min.push_back(start.density_min[m] / expansion);
    bounds.density_max.push_back(start.density_max[m] * compression);
  }
  double const signal = start.signal_speed + fall_speed(model);
  bounds.speed = settings.speed * signal;
  double const largest = std::max(std::fabs(start.energy_min), std::fabs(start.energy_max));
  double const reach = settings.specific_energy * (largest + 0.5 * signal * signal);
  bounds.energy_min = start.energy_min - reach;
  bounds.energy_max = start.energy_max + reach;
  bounds.time_step = settings.time_step * model.time.courant * model.numerics.smoothing_length() /
                     start.signal_speed;
  bounds.wall_depth = settings.wall_depth * model.numerics.spacing;
  return bounds;
}

}  // namespace moraine
