#include "setup/build_model.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/input_error.hpp"
#include "setup/absorbing_layers.hpp"
#include "setup/case_size.hpp"
#include "setup/check_burn.hpp"
#include "setup/check_strength.hpp"
#include "setup/fill.hpp"
#include "setup/geometry.hpp"
#include "setup/mirror_walls.hpp"
#include "setup/region_lattice.hpp"
#include "setup/start_particles.hpp"
#include "setup/wall_parts.hpp"

namespace moraine {
namespace {

constexpr double not_lit = std::numeric_limits<double>::infinity();

void set_vector(ParticleStore& store, Field field, std::size_t i, Point const& value) {
  for (int axis = 0; axis < store.dimension(); ++axis)
    store.component(field, axis)[i] = value[static_cast<std::size_t>(axis)];
}

/// Ids of the particles that were made of each region and of each wall, ascending.
struct Members {
  std::vector<std::vector<std::uint64_t>> regions;
  std::vector<std::vector<std::uint64_t>> walls;
};

/// Stress and strain of a particle that goes on as a solid, where both runs have solids, and
/// whether it has parted, where it still can.
void copy_solid(ParticleStore const& old, std::size_t from, Model& model, std::size_t to) {
  ParticleStore& store = model.particles;
  Material const& material = model.materials[store.material()[to]];
  for (Field const field :
       {Field::deviatoric_stress, Field::plastic_strain, Field::plastic_work, Field::spalled}) {
    bool const wanted = field == Field::spalled ? material.spalls : is_solid(material.strength);
    if (!wanted || !old.has(field)) continue;
    for (int k = 0; k < components(info(field).rank, store.dimension()); ++k)
      store.component(field, k)[to] = old.component(field, k)[from];
  }
}

/// What a particle remembers that nothing has happened to.
void set_memory(Model& model, std::size_t i) {
  ParticleStore& store = model.particles;
  if (store.has(Field::lighting_time)) store.scalar(Field::lighting_time)[i] = not_lit;
  if (store.has(Field::distension))
    store.scalar(Field::distension)[i] =
        virgin_distension(model.materials[store.material()[i]].eos);
}

// In the order of the ids that they had; their new ids count from zero.
void add_start_particles(Case const& c, Model& model) {
  ParticleStore& store = model.particles;
  for (std::size_t const from : kept_start_particles(c)) {
    ParticleStore const& old = *c.start.particles;
    std::size_t const i = store.append(Kind::fluid, start_material(c, old.material()[from]));
    for (int axis = 0; axis < store.dimension(); ++axis) {
      store.component(Field::position, axis)[i] = old.component(Field::position, axis)[from];
      if (c.start.velocities == StartVelocities::keep)
        store.component(Field::velocity, axis)[i] = old.component(Field::velocity, axis)[from];
    }
    for (Field const field : {Field::density, Field::specific_energy, Field::mass})
      store.scalar(field)[i] = old.scalar(field)[from];
    copy_solid(old, from, model, i);
    set_memory(model, i);
    if (store.has(Field::distension) && old.has(Field::distension) &&
        start_knows_compaction(c, old.material()[from]))  // stays compacted
      store.scalar(Field::distension)[i] = old.scalar(Field::distension)[from];
    if (!store.has(Field::lighting_time) || !old.has(Field::lighting_time)) continue;
    // Goes on where it had begun to burn.
    store.scalar(Field::burn_fraction)[i] = old.scalar(Field::burn_fraction)[from];
    store.scalar(Field::lighting_time)[i] =
        old.scalar(Field::lighting_time)[from] - c.start.info.time;
  }
}

void add_fluid(Case const& c, Model& model, Members& members) {
  ParticleStore& store = model.particles;
  members.regions.resize(c.regions.size());
  for (Seed const& seed : fill_regions(c)) {
    std::size_t const i = store.append(Kind::fluid, seed.material);
    members.regions[seed.region].push_back(store.id()[i]);
    set_vector(store, Field::position, i, seed.position);
    set_vector(store, Field::velocity, i, seed.velocity);
    store.scalar(Field::density)[i] = seed.density;
    store.scalar(Field::specific_energy)[i] = seed.specific_energy;
    store.scalar(Field::mass)[i] = seed.mass;
    set_memory(model, i);
  }
}

/// The faces of a wall that moves are part of its body.
void add_faces_to_body(Case const& c, WallSpec const& spec, std::uint32_t wall, std::uint16_t body,
                       WallData& walls) {
  for (WallFace& face : walls.faces) {
    if (face.wall != wall) continue;
    face.body = body;
    double& radius = walls.bodies[body].radius;
    for (std::size_t corner = 0; corner < (std::size_t{1} << c.dimension); ++corner) {
      Vec3 place = face.low;
      for (std::size_t k = 0; k < 3; ++k)
        if (((corner >> k) & 1) != 0) place[k] = face.high[k];
      radius = std::max(radius, norm(subtract(place, spec.motion.motion->about)));
    }
  }
}

void add_walls(Case const& c, Model& model, Members& members) {
  ParticleStore& store = model.particles;
  model.walls.first_id = store.size();
  bool const any_moves = std::any_of(c.walls.begin(), c.walls.end(), [](WallSpec const& spec) {
    return spec.motion.motion.has_value();
  });
  double const density = reference_density(model.materials.front().eos);
  std::uint32_t surface = 0;
  std::vector<InputProblem> problems;
  for (WallSpec const& spec : c.walls) {
    std::vector<Dummy> dummies;
    auto& ids = members.walls.emplace_back();
    try {
      dummies = make_wall_dummies(c, spec, surface);
      auto const faces = faces_of_wall(c, surface);
      model.walls.faces.insert(model.walls.faces.end(), faces.begin(), faces.end());
    } catch (std::invalid_argument const& error) {
      problems.push_back(problem_of(c, "wall." + spec.name, error.what()));
    }
    std::uint16_t body = WallPoint::at_rest;
    if (spec.motion.motion) {
      body = static_cast<std::uint16_t>(model.walls.bodies.size());
      model.walls.bodies.push_back({*spec.motion.motion});
      add_faces_to_body(c, spec, surface, body, model.walls);
    }
    for (Dummy const& dummy : dummies) {
      std::size_t const i = store.append(Kind::wall, no_material);
      ids.push_back(store.id()[i]);
      set_vector(store, Field::position, i, dummy.position);
      store.scalar(Field::density)[i] = density;
      WallPoint point{{},
                      static_cast<float>(dummy.depth),
                      spec.slip == Slip::free,
                      static_cast<float>(wall_clearance(c, spec, dummy)),
                      body};
      for (std::size_t axis = 0; axis < 3; ++axis)
        point.normal[axis] = static_cast<float>(dummy.normal[axis]);
      model.walls.points.push_back(point);
      if (any_moves) model.walls.start.push_back(dummy.position);
      if (body == WallPoint::at_rest) continue;
      MovingWall& wall = model.walls.bodies[body];
      wall.radius = std::max(wall.radius, length(subtract(dummy.position, wall.motion.about)));
    }
    ++surface;
  }
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

/// Index of the item with this name; the case has been checked for it.
template <class Spec>
std::size_t index_of(std::vector<Spec> const& specs, std::string const& name) {
  auto const found =
      std::find_if(specs.begin(), specs.end(), [&](Spec const& s) { return s.name == name; });
  return static_cast<std::size_t>(found - specs.begin());
}

StageEnd stage_end(Case const& c, UntilSpec const& until) {
  StageEnd end;
  if (until.after) end.after = *until.after;
  end.rms_speed_below = until.rms_speed_below.value_or(0.0);
  end.steady_for = until.steady_for.value_or(0.0);
  if (!until.gauge.empty())
    end.pressure = PressureLimit{
        c.gauges[index_of(c.gauges, until.gauge)].position,
        until.pressure_above ? *until.pressure_above : until.pressure_below.value_or(0.0),
        until.pressure_above.has_value()};
  return end;
}

void add_stages(Case const& c, Model& model, Members const& members) {
  for (StageSpec const& spec : c.stages) {
    Stage stage{spec.name, 0.0, stage_end(c, spec.until), {}, {}};
    if (spec.damping_time) stage.damping = 1.0 / *spec.damping_time;
    if (!spec.remove_wall.empty())
      stage.removed_walls = members.walls[index_of(c.walls, spec.remove_wall)];
    if (!spec.detonate.empty()) {
      std::size_t const material = index_of(c.materials, spec.into);
      stage.transformations.push_back({members.regions[index_of(c.regions, spec.detonate)],
                                       static_cast<MaterialId>(material),
                                       reference_energy(c.materials[material].eos)});
    }
    model.stages.push_back(std::move(stage));
  }
}

/// A particle must not see another one and its image, nor itself.
void check_periods(Case const& c) {
  double const least = 2.0 * kernel_support * c.numerics.largest_smoothing_length();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    double const period = c.domain.max[axis] - c.domain.min[axis];
    bool const reflects = c.symmetry.planes[axis][0] || c.symmetry.planes[axis][1];
    auto const mirrors = mirror_sides(c)[axis];
    if (!(c.periodic[axis] || reflects || mirrors[0] || mirrors[1]) || period >= least) continue;
    if (auto const wall = mirrors[0] ? mirrors[0] : mirrors[1])
      throw InputErrors(
          {problem_of(c, "wall." + c.walls[*wall].name + ".method",
                      fmt::format("makes images of a container of {:.4g} m along {}, shorter than "
                                  "two kernel supports, {:.4g} m",
                                  period, "xyz"[axis], least),
                      "refine the spacing or let it be \"dummy\"")});
    throw InputErrors(
        {problem_of(c, reflects ? "space.symmetry" : "space.periodic",
                    fmt::format("makes {} of {:.4g} m, shorter than two kernel supports, {:.4g} m",
                                reflects ? "a domain" : "a period", period, least),
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
  model.symmetry = c.symmetry;
  model.mirror_walls = mirror_planes(c);
  model.gravity = c.gravity;
  model.numerics = c.numerics;
  model.finest_spacing = finest_spacing(c);
  if (!c.start.run.empty())
    model.finest_spacing = std::min(model.finest_spacing, c.start.info.finest_spacing);
  model.time = c.time;
  model.guards = c.guards;
  model.particles = ParticleStore(c.dimension);
  for (MaterialSpec const& material : c.materials) {
    model.materials.push_back({material.name, material.eos});
    model.materials.back().dynamic_viscosity = material.dynamic_viscosity;
    model.materials.back().strength = strength_of(material.strength);
    model.materials.back().spalls = material.tension == TensionEnd::spall;
    if (model.materials.back().spalls) model.particles.use(Field::spalled);
    if (can_compact(material.eos)) model.particles.use(Field::distension);
    model.materials.back().penalty_group = material.group();
    if (material.burn.kind != BurnKind::programmed) continue;
    model.materials.back().burn = burn_of(material, c.numerics.spacing);
    for (Field const field : {Field::burn_fraction, Field::lighting_time})
      model.particles.use(field);
  }
  if (model.has_solids())
    for (Field const field : solid_fields) model.particles.use(field);
  Members members;
  add_start_particles(c, model);
  add_fluid(c, model, members);
  add_absorbing_layers(c, model);
  add_walls(c, model, members);
  add_stages(c, model, members);
  check_wall_parts(c);
  return model;
}

}  // namespace moraine
