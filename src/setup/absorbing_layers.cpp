#include "setup/absorbing_layers.hpp"

#include <variant>

#include "store/place.hpp"

namespace moraine {
namespace {

/// Explosives end nowhere: they burst.
bool can_absorb(Model const& model, std::size_t i) {
  return !std::holds_alternative<Jwl>(model.materials[model.particles.material()[i]].eos);
}

}  // namespace

void add_absorbing_layers(Case const& c, Model& model) {
  AbsorbingSpec const& spec = c.absorbing;
  ParticleStore& store = model.particles;
  std::size_t const count = store.range(Kind::fluid).size();
  double const half = 0.5 * c.numerics.spacing;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    for (std::size_t end = 0; end < 2; ++end) {
      if (!spec.sides[axis][end]) continue;
      auto const x = store.component(Field::position, static_cast<int>(axis));
      auto& farthest = model.absorbing.ends[axis][end];
      double const outwards = end == 0 ? -1.0 : 1.0;
      for (std::size_t i = 0; i < count; ++i)
        if (can_absorb(model, i) && (!farthest || outwards * (x[i] - *farthest) + half > 0.0))
          farthest = x[i] + outwards * half;
      if (farthest) model.absorbing.thickness = spec.thickness;
    }
  model.absorbing.reflection = spec.reflection;
  if (!model.absorbing.any()) return;
  store.use(Field::rest_density);
  for (std::size_t i = 0; i < count; ++i) {
    if (can_absorb(model, i) && model.absorbing.fading(place_of(store, i)) > 0.0)
      store.scalar(Field::rest_density)[i] = store.scalar(Field::density)[i];
  }
}

}  // namespace moraine
