#include "plane_slab.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "exact/uniaxial_solid.hpp"
#include "setup/build_model.hpp"
#include "setup/check_strength.hpp"
#include "setup/materials.hpp"
#include "step/simulation.hpp"
#include "verify/l1_errors.hpp"
#include "verify/particle_value.hpp"
#include "verify/thrown_block.hpp"

namespace moraine {
namespace {

Case slab_on(MaterialSpec const& soil, double spacing) {
  Case c;
  c.dimension = 1;
  c.domain = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  c.numerics.spacing = spacing;
  c.numerics.smoothing_factor = 2.0;
  c.numerics.smoothing.mode = SmoothingMode::density;
  c.numerics.continuity = ContinuityForm::volume;
  c.numerics.momentum = MomentumForm::mixed;
  c.numerics.precision = Precision::full;
  c.time.end = 1e-3;  // never reached
  c.materials = {shipped_material("tnt").spec, soil};
  c.regions = {{"slab", "tnt", Box{{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}}, {}},
               {"ground", soil.name, Box{{0.3, 0.0, 0.0}, {0.7, 0.0, 0.0}}, {}}};
  WallSpec wall;
  wall.name = "end";
  wall.box = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  wall.open[0][1] = true;
  c.walls = {wall};
  return c;
}

/// Farthest place of the ground where the axial stress is above `level`.
double front(ParticleStore const& store, double level) {
  double place = 0.3;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.material()[i] == 1 && axial_stress(store, i) > level)
      place = std::max(place, store.component(Field::position, 0)[i]);
  return place;
}

}  // namespace

Law law_along_axis(MaterialSpec const& soil) {
  return UniaxialSolid{soil.eos, strength_of(soil.strength)};
}

RiemannProblem slab_solution(MaterialSpec const& soil) {
  MaterialSpec const& tnt = shipped_material("tnt").spec;
  return {{Law(tnt.eos), reference_density(tnt.eos), 0.0, reference_energy(tnt.eos)},
          {law_along_axis(soil), reference_density(soil.eos), 0.0, reference_energy(soil.eos)}};
}

void add_slab(char const* name, double spacing, std::vector<CheckResult>& results) {
  MaterialSpec const& soil = shipped_material(name).spec;
  RiemannProblem const exact = slab_solution(soil);
  double const p = exact.star_pressure();
  Simulation simulation(build_model(slab_on(soil, spacing)));
  ParticleStore const& store = simulation.particles();
  constexpr double depth =
      0.15;  // m, of the gauge; the plateau lasts until the release from behind
  while (simulation.running() && front(store, 0.5 * p) < 0.3 + depth) simulation.advance();
  double const time = simulation.time();
  double const arrival = depth / exact.right_wave()->head;
  double const contact = 0.3 + exact.star_velocity() * time;
  double const shocked = 0.3 + depth - contact;
  results.push_back(compare(fmt::format("surface-charge: plane slab on {}, arrival", name),
                            1e6 * time, 1e6 * arrival, 0.03e6 * arrival, "us",
                            "15 cm inside the ground; exact: Riemann problem"));
  results.push_back(compare(
      fmt::format("surface-charge: plane slab on {}, stress", name),
      1e-9 * mean_of(simulation, axial_stress, contact + 0.2 * shocked, contact + 0.8 * shocked),
      1e-9 * p, 0.03e-9 * p, "GPa", "plateau behind the shock"));
}

}  // namespace moraine
