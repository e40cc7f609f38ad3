// Ground with a crater of known shape, and pieces that fly above it.
#pragma once

#include <functional>
#include <vector>

#include "setup/build_model.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// A case of ground in the box [-side, side] x ... of `depth` below zero and `above` over it, and a
/// block of `ejecta` 5 spacings wide that hangs `gap` [m] above the ground, without gravity. Height
/// along the last axis.
inline Case ground_case(int dimension, double spacing, double side, double depth, double above,
                        double gap) {
  Case c;
  c.dimension = dimension;
  auto const up = static_cast<std::size_t>(dimension - 1);
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 1.2;
  Box ground{{-side, -side, -side}, {side, side, side}};
  ground.min[up] = -depth;
  ground.max[up] = above;
  Box ejecta{{0.0, 0.0, 0.0}, {5 * spacing, 5 * spacing, 5 * spacing}};
  ejecta.min[up] += above + gap;
  ejecta.max[up] += above + gap;
  c.domain = {{-side, -side, -side}, {side, side, side}};
  c.domain.min[up] = -2.0 * depth;
  c.domain.max[up] = 2.0 * (above + gap) + 10 * spacing;
  c.time.end = 1.0;
  c.materials = {{"soil", Tait{}}};
  c.regions = {{"ground", "soil", ground, {}}, {"ejecta", "soil", ejecta, {}}};
  return c;
}

/// The model of ground_case without the particles of the ground above this height; `height` of the
/// horizontal distance from the origin.
inline Model carved(Case const& c, double top, std::function<double(double)> const& height) {
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  int const up = c.dimension - 1;
  std::vector<std::uint32_t> gone;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double r2 = 0.0;
    for (int axis = 0; axis < up; ++axis)
      r2 += store.component(Field::position, axis)[i] * store.component(Field::position, axis)[i];
    double const z = store.component(Field::position, up)[i];
    if (z < top && z > height(std::sqrt(r2))) gone.push_back(static_cast<std::uint32_t>(i));
  }
  store.remove(gone);
  return model;
}

}  // namespace moraine
