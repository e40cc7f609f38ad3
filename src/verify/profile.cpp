#include "verify/profile.hpp"

#include <algorithm>
#include <limits>

namespace moraine {

double mean_between(Simulation const& simulation, Field field, double from, double to) {
  ParticleStore const& store = simulation.particles();
  auto const x = store.component(Field::position, 0);
  double sum = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    if (!(x[i] >= from && x[i] < to)) continue;
    double const own = store.scalar(Field::mass)[i] / store.scalar(Field::density)[i];
    sum += own * store.scalar(field)[i];
    volume += own;
  }
  return sum / volume;
}

double front_of_pressure(Simulation const& simulation, double least) {
  ParticleStore const& store = simulation.particles();
  auto const x = store.component(Field::position, 0);
  auto const p = store.scalar(Field::pressure);
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (p[i] > least) most = std::max(most, x[i]);
  return most;
}

}  // namespace moraine
