// What a stage changes when it begins.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "step/simulation.hpp"

namespace moraine {

void Simulation::change_stage() {
  std::string cause = stages_.ended(*this);
  if (cause.empty()) return;
  stages_.begin_next(time_, step_, std::move(cause));
  begin_stage();
  evaluate_rates();
  if (on_new_rates_) on_new_rates_(*this);
}

void Simulation::begin_stage() {
  Stage const* const stage = stages_.current();
  if (stage == nullptr) return;
  remove_walls(stage->removed_walls);
  for (Transformation const& change : stage->transformations) transform(change);
  sort_by_material();
}

void Simulation::remove_walls(std::span<std::uint64_t const> ids) {
  if (ids.empty()) return;
  ParticleStore& store = model_.particles;
  Range const walls = store.range(Kind::wall);
  std::vector<std::uint32_t> removed;
  for (std::size_t i = walls.begin; i < walls.end; ++i)
    if (std::binary_search(ids.begin(), ids.end(), store.id()[i]))
      removed.push_back(static_cast<std::uint32_t>(i));
  store.remove(removed);
  search_.forget_walls();
  find_present_walls();
}

void Simulation::transform(Transformation const& change) {
  ParticleStore& store = model_.particles;
  Range const fluid = store.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i) {
    if (!std::binary_search(change.ids.begin(), change.ids.end(), store.id()[i])) continue;
    double& energy = store.scalar(Field::specific_energy)[i];
    booked_.detonation += store.scalar(Field::mass)[i] * (change.specific_energy - energy);
    bool const is_new = store.material()[i] != change.material;
    store.set_material(i, change.material);
    energy = change.specific_energy;
    if (store.has(Field::rest_density)) store.scalar(Field::rest_density)[i] = 0.0;
    if (is_new && store.has(Field::spalled)) store.scalar(Field::spalled)[i] = 0.0;
    if (is_new && store.has(Field::deviatoric_stress))
      for (int k = 0; k < components(Rank::symmetric, store.dimension()); ++k)
        store.component(Field::deviatoric_stress, k)[i] = 0.0;
    if (is_new && store.has(Field::distension))
      store.scalar(Field::distension)[i] = virgin_distension(model_.materials[change.material].eos);
    if (!model_.materials[change.material].burn) continue;
    if (is_new) store.scalar(Field::burn_fraction)[i] = 0.0;
    light(i);
  }
}

}  // namespace moraine
