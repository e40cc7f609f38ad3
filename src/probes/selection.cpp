#include "probes/selection.hpp"

#include <algorithm>
#include <cmath>

namespace moraine {

bool Selection::has(ParticleStore const& store, std::size_t i) const {
  bool const right = materials.empty() || std::find(materials.begin(), materials.end(),
                                                    store.material()[i]) != materials.end();
  return right && (!within || within->holds(particle_place(store, i), store.dimension()));
}

std::vector<std::uint8_t> Selection::of(ParticleStore const& store) const {
  std::vector<std::uint8_t> chosen(store.range(Kind::fluid).size());
  for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = has(store, i) ? 1 : 0;
  return chosen;
}

double size_of_particle(ParticleStore const& store, std::size_t i) {
  double const volume = store.scalar(Field::mass)[i] / store.scalar(Field::density)[i];
  if (store.dimension() == 1) return volume;
  return store.dimension() == 2 ? std::sqrt(volume) : std::cbrt(volume);
}

}  // namespace moraine
