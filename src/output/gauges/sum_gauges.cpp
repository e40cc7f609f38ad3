// Gauges of kind sums, side and budget.
#include "output/gauges/gauge_columns.hpp"
#include "output/gauges/makers.hpp"
#include "probes/material_sums.hpp"

namespace moraine {

GaugeReader sums_reader(Case const& c, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  GaugeReader reader{name,
                     {{name + " particles", ""},
                      {name + " mass", "kg"},
                      {name + " kinetic_energy", "J"},
                      {name + " internal_energy", "J"},
                      {name + " potential_energy", "J"}},
                     {}};
  add_vector_columns(reader.columns, name + " momentum", c.dimension, "kg m/s");
  reader.read = [material = material_of(c, gauge.probe.of)](ReadingContext const& at,
                                                            std::vector<double>& row) {
    Model const& model = at.simulation.model();
    MaterialSums const sums = sum_material(at.simulation.particles(), material, model.gravity);
    Symmetry const& planes = model.symmetry;
    Vec3 const momentum = planes.whole(sums.momentum);
    row.insert(row.end(), {static_cast<double>(sums.particles), planes.whole(sums.mass),
                           planes.whole(sums.kinetic_energy), planes.whole(sums.internal_energy),
                           planes.whole(sums.potential_energy)});
    row.insert(row.end(), momentum.begin(), momentum.begin() + model.dimension);
    return sums.particles > 0;
  };
  return reader;
}

GaugeReader side_reader(Case const&, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  auto const read = [side = static_cast<std::size_t>(gauge.probe.side)](ReadingContext const& at,
                                                                        std::vector<double>& row) {
    LostParticles const& lost = at.simulation.lost_through()[side];
    Symmetry const& planes = at.simulation.model().symmetry;
    row.insert(row.end(), {static_cast<double>(lost.count), planes.whole(lost.mass),
                           planes.whole(lost.energy)});
    return lost.count > 0;
  };
  return {
      name,
      {{name + " lost_particles", ""}, {name + " lost_mass", "kg"}, {name + " lost_energy", "J"}},
      read};
}

GaugeReader budget_reader(Case const&, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  auto const read = [](ReadingContext const& at, std::vector<double>& row) {
    Symmetry const& planes = at.simulation.model().symmetry;
    for (double const amount :
         {at.budget.viscosity(), at.budget.wall_viscosity(), at.budget.compression(),
          at.budget.diffusion(), at.simulation.booked().walls, at.simulation.lost().energy,
          at.budget.error(at.simulation), at.simulation.booked().damping,
          at.simulation.booked().detonation})
      row.push_back(planes.whole(amount));
    return true;
  };
  return {name,
          {{name + " viscosity", "J"},
           {name + " wall_viscosity", "J"},
           {name + " compression", "J"},
           {name + " diffusion", "J"},
           {name + " wall_work", "J"},
           {name + " lost_energy", "J"},
           {name + " energy_error", "J"},
           {name + " damping", "J"},
           {name + " detonation", "J"}},
          read};
}

}  // namespace moraine
