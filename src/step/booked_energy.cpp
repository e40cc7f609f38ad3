#include "step/booked_energy.hpp"

#include "base/parallel_for.hpp"
#include "step/simulation.hpp"

namespace moraine {

void BookedEnergy::exchange(Archive& archive) {
  archive.number("booked_energy/damping", damping);
  archive.number("booked_energy/detonation", detonation);
  archive.number("booked_energy/walls", walls);
  archive.number("booked_energy/drift", drift);
}

double power_of_damping(ParticleStore const& store, double damping, double half) {
  auto const mass = store.scalar(Field::mass);
  auto const add = [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (int axis = 0; axis < store.dimension(); ++axis) {
      auto const v = store.component(Field::velocity, axis);
      auto const a = store.component(Field::acceleration, axis);
      for (std::size_t i = begin; i < end; ++i) sum += mass[i] * v[i] * (v[i] - half * a[i]);
    }
    return sum;
  };
  return -damping * reduce_blocks(store.range(Kind::fluid).size(), 0.0, add,
                                  [](double a, double b) { return a + b; });
}

double power_of_drift(ParticleStore const& store, std::array<double, 3> const& gravity) {
  if (!store.has(Field::drift)) return 0.0;
  auto const mass = store.scalar(Field::mass);
  auto const add = [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (int axis = 0; axis < store.dimension(); ++axis) {
      auto const drift = store.component(Field::drift, axis);
      double const g = gravity[static_cast<std::size_t>(axis)];
      for (std::size_t i = begin; i < end; ++i) sum -= mass[i] * g * drift[i];
    }
    return sum;
  };
  return reduce_blocks(store.range(Kind::fluid).size(), 0.0, add,
                       [](double a, double b) { return a + b; });
}

double energy_balance(ConservedSums const& sums, LostParticles const& lost,
                      BookedEnergy const& booked) {
  return sums.total_energy() + lost.energy - booked.total();
}

}  // namespace moraine
