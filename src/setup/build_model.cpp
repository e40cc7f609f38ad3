#include "setup/build_model.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/input_error.hpp"
#include "setup/case_size.hpp"
#include "setup/fill.hpp"
#include "walls/dummy_layer.hpp"

namespace moraine {
namespace {

void set_vector(ParticleStore& store, Field field, std::size_t i, Point const& value) {
  for (int axis = 0; axis < store.dimension(); ++axis)
    store.component(field, axis)[i] = value[static_cast<std::size_t>(axis)];
}

void add_fluid(Case const& c, Model& model) {
  ParticleStore& store = model.particles;
  for (Seed const& seed : fill_regions(c)) {
    std::size_t const i = store.append(Kind::fluid, seed.material);
    set_vector(store, Field::position, i, seed.position);
    set_vector(store, Field::velocity, i, seed.velocity);
    store.scalar(Field::density)[i] = seed.density;
    store.scalar(Field::specific_energy)[i] = seed.specific_energy;
    store.scalar(Field::mass)[i] = seed.mass;
  }
}

BoxWall box_wall(Case const& c, WallSpec const& spec) {
  BoxWall wall;
  wall.dimension = c.dimension;
  wall.min = spec.box.min;
  wall.max = spec.box.max;
  wall.solid = spec.form == WallForm::container ? SolidSide::outside : SolidSide::inside;
  wall.open = spec.open;
  wall.periodic = {c.periodic, c.domain.min, c.domain.max};
  return wall;
}

void add_walls(Case const& c, Model& model) {
  ParticleStore& store = model.particles;
  model.walls.first_id = store.size();
  double const density = reference_density(model.materials.front().eos);
  int const layers =
      static_cast<int>(std::ceil(kernel_support * c.numerics.smoothing_factor - 1e-9));
  std::uint32_t surface = 0;
  std::vector<InputProblem> problems;
  for (WallSpec const& spec : c.walls) {
    std::vector<Dummy> dummies;
    try {
      dummies = make_dummy_layer(box_wall(c, spec), c.numerics.spacing, layers, surface);
    } catch (std::invalid_argument const& error) {
      problems.push_back(problem_of(c, "wall." + spec.name, error.what()));
    }
    for (Dummy const& dummy : dummies) {
      std::size_t const i = store.append(Kind::wall, no_material);
      set_vector(store, Field::position, i, dummy.position);
      store.scalar(Field::density)[i] = density;
      WallPoint point{{}, static_cast<float>(dummy.depth), spec.slip == Slip::free};
      for (std::size_t axis = 0; axis < 3; ++axis)
        point.normal[axis] = static_cast<float>(dummy.normal[axis]);
      model.walls.points.push_back(point);
    }
    ++surface;
  }
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

/// A particle must not see another one and its image, nor itself.
void check_periods(Case const& c) {
  double const least = 2.0 * kernel_support * c.numerics.smoothing_length();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    double const period = c.domain.max[axis] - c.domain.min[axis];
    if (!c.periodic[axis] || period >= least) continue;
    throw InputErrors({problem_of(
        c, "space.periodic",
        fmt::format("makes a period of {:.4g} m, shorter than two kernel supports, {:.4g} m",
                    period, least),
        "widen the domain or refine the spacing")});
  }
}

}  // namespace

Model build_model(Case const& c) {
  check_periods(c);
  check_size(c);
  Model model;
  model.dimension = c.dimension;
  model.domain_min = c.domain.min;
  model.domain_max = c.domain.max;
  model.periodic = c.periodic;
  model.gravity = c.gravity;
  model.numerics = c.numerics;
  model.time = c.time;
  for (MaterialSpec const& material : c.materials)
    model.materials.push_back({material.name, material.eos});
  model.particles = ParticleStore(c.dimension);
  add_fluid(c, model);
  add_walls(c, model);
  return model;
}

}  // namespace moraine
