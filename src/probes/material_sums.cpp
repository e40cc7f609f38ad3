#include "probes/material_sums.hpp"

#include "base/parallel_for.hpp"

namespace moraine {
namespace {

void include(MaterialSums& sums, ParticleStore const& store, std::size_t i, Vec3 const& gravity) {
  double const mass = store.scalar(Field::mass)[i];
  ++sums.particles;
  sums.mass += mass;
  sums.internal_energy += mass * store.scalar(Field::specific_energy)[i];
  for (int axis = 0; axis < store.dimension(); ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    double const v = store.component(Field::velocity, axis)[i];
    sums.kinetic_energy += 0.5 * mass * v * v;
    sums.momentum[k] += mass * v;
    sums.potential_energy -= mass * gravity[k] * store.component(Field::position, axis)[i];
  }
}

}  // namespace

MaterialSums sum_material(ParticleStore const& store, MaterialId material, Vec3 const& gravity) {
  auto const of_block = [&](std::size_t begin, std::size_t end) {
    MaterialSums sums;
    for (std::size_t i = begin; i < end; ++i)
      if (store.material()[i] == material) include(sums, store, i, gravity);
    return sums;
  };
  auto const combine = [](MaterialSums a, MaterialSums const& b) {
    a.particles += b.particles;
    a.mass += b.mass;
    a.kinetic_energy += b.kinetic_energy;
    a.internal_energy += b.internal_energy;
    a.potential_energy += b.potential_energy;
    a.momentum = add(a.momentum, b.momentum);
    return a;
  };
  return reduce_blocks(store.range(Kind::fluid).size(), MaterialSums{}, of_block, combine);
}

}  // namespace moraine
