#include "support/small_models.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "setup/build_model.hpp"
#include "walls/dummy_layer.hpp"

namespace moraine {

Model walled_random_box(RandomBox const& box, double end) {
  Model model = random_box(box, end);
  model.periodic[0] = false;
  model.gravity = {0.0, -9.81, 0.0};
  model.walls.first_id = model.particles.size();
  BoxWall wall;
  wall.dimension = box.dimension;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(box.dimension); ++axis)
    wall.max[axis] = model.domain_max[axis];
  wall.periodic = {model.periodic, wall.min, wall.max};
  for (Dummy const& dummy : make_dummy_layer(wall, model.numerics.spacing, 3, 0)) {
    std::size_t const i = model.particles.append(Kind::wall, no_material);
    for (int axis = 0; axis < box.dimension; ++axis)
      model.particles.component(Field::position, axis)[i] =
          dummy.position[static_cast<std::size_t>(axis)];
    model.particles.scalar(Field::density)[i] = 1000.0;
    WallPoint point{{}, static_cast<float>(dummy.depth), true};
    for (std::size_t axis = 0; axis < 3; ++axis)
      point.normal[axis] = static_cast<float>(dummy.normal[axis]);
    model.walls.points.push_back(point);
  }
  return model;
}

Model small_dam_break(int dimension, Precision precision, double end, double spacing) {
  Case c;
  c.dimension = dimension;
  auto const up = static_cast<std::size_t>(dimension - 1);
  Box tank{{0.0, 0.0, 0.0}, {0.8, 0.2, 0.0}};
  Box column{{0.0, 0.0, 0.0}, {0.4, 0.2, 0.0}};
  tank.max[up] = 0.6;
  column.max[up] = 0.3;
  c.domain = {{-1.0, -1.0, -1.0}, {2.0, 2.0, 2.0}};
  c.gravity[up] = -9.81;
  c.numerics.spacing = spacing;
  c.numerics.viscosity_alpha = 0.1;
  c.numerics.viscosity_beta = 0.0;
  c.numerics.density_diffusion = 0.1;
  c.numerics.precision = precision;
  c.time.end = end;
  Tait water;
  water.reference_sound_speed = 25.0;
  c.materials = {{"water", water}};
  c.regions = {{"column", "water", column, {}}};
  WallSpec wall;
  wall.name = "tank";
  wall.box = tank;
  c.walls = {wall};
  return build_model(c);
}

Model blast_in_periodic_water(int dimension, int side, Precision precision,
                              ContinuityForm continuity) {
  Case c;
  c.dimension = dimension;
  c.numerics.spacing = 0.01;
  double const half = 0.5 * side * c.numerics.spacing;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    c.domain.min[axis] = -half;
    c.domain.max[axis] = half;
    c.periodic[axis] = true;
  }
  c.numerics.precision = precision;
  c.numerics.continuity = continuity;
  c.time.end = 1.0;
  c.materials = {{"water", WaterPolynomial{}}, {"tnt", Jwl{}}};
  c.regions = {{"sea", "water", c.domain, {}}, {"charge", "tnt", Disc{{}, 0.25 * half}, {}}};
  return build_model(c);
}

Model with_options(Model model) {
  Numerics& numerics = model.numerics;
  numerics.physical_viscosity = ViscosityForm::monaghan_cleary;
  for (Material& material : model.materials) material.dynamic_viscosity = 5.0;
  numerics.xsph = 0.3;
  numerics.shifting = 1.0;
  numerics.density_diffusion = 0.1;
  numerics.diffusion = DiffusionForm::gradient;
  numerics.gradient_correction = GradientCorrection::bonet_lok;
  numerics.penalty.strength = 1e3;
  return model;
}

Model with_summed_density(Model model) {
  model.numerics.density = DensityForm::normalised;
  model.numerics.physical_viscosity = ViscosityForm::morris;
  for (Material& material : model.materials) material.dynamic_viscosity = 5.0;
  return model;
}

Model with_strength(Model model) {
  model.materials.front().strength = DruckerPrager{1e8, 0.2, 1e5};
  model.numerics.artificial_stress = 0.3;
  return model;
}

void stir(Model& model, double speed) {
  ParticleStore& store = model.particles;
  for (int axis = 0; axis < model.dimension; ++axis)
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      store.component(Field::velocity, axis)[i] +=
          speed * std::sin(static_cast<double>(7 * store.id()[i] + 3) + axis);
}

std::vector<double> state_by_id(ParticleStore const& store) {
  std::size_t const count = store.range(Kind::fluid).size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return store.id()[a] < store.id()[b]; });
  std::vector<double> state;
  for (FieldInfo const& field : field_table) {
    if (!store.has(field.field)) continue;
    for (int axis = 0; axis < components(field.rank, store.dimension()); ++axis)
      for (std::size_t const i : order) state.push_back(store.component(field.field, axis)[i]);
  }
  return state;
}

double largest(ParticleStore const& store, Field field, int axis) {
  auto const values = store.component(field, axis);
  double most = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    most = std::max(most, std::fabs(values[i]));
  return most;
}

}  // namespace moraine
