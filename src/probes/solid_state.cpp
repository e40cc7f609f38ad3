#include "probes/solid_state.hpp"

namespace moraine {
namespace {

template <int D>
Deviator deviator(ParticleStore const& store, std::size_t i) {
  Symmetric<D> kept{};
  for (int k = 0; k < symmetric_size<D>; ++k)
    kept[static_cast<std::size_t>(k)] = store.component(Field::deviatoric_stress, k)[i];
  return unpacked<D>(kept);
}

}  // namespace

Deviator deviator_of(ParticleStore const& store, std::size_t i) {
  if (!store.has(Field::deviatoric_stress)) return {};
  if (store.dimension() == 1) return deviator<1>(store, i);
  if (store.dimension() == 2) return deviator<2>(store, i);
  return deviator<3>(store, i);
}

}  // namespace moraine
