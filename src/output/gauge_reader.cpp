#include "output/gauge_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "probes/level_probe.hpp"
#include "probes/material_sums.hpp"
#include "probes/point_probe.hpp"
#include "setup/wall_parts.hpp"

namespace moraine {
namespace {

constexpr std::array axis_letter{'x', 'y', 'z'};

void add_vector_columns(std::vector<TableColumn>& columns, std::string const& name, int dimension,
                        std::string const& unit) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    columns.push_back({fmt::format("{}_{}", name, axis_letter[axis]), unit});
}

void add_point_columns(std::vector<TableColumn>& columns, std::string const& name, int dimension) {
  columns.push_back({name + " pressure", "Pa"});
  columns.push_back({name + " density", "kg/m^3"});
  columns.push_back({name + " specific_energy", "J/kg"});
  add_vector_columns(columns, name + " velocity", dimension, "m/s");
}

/// Appends the state at a point; false where no fluid is near.
bool read_point(Simulation const& simulation, Vec3 const& place, std::vector<double>& row) {
  Model const& model = simulation.model();
  PointState const state =
      probe_point(simulation.particles(), simulation.search(), model.numerics.kernel,
                  model.numerics.smoothing_length(), place);
  row.insert(row.end(), {state.pressure, state.density, state.specific_energy});
  row.insert(row.end(), state.velocity.begin(), state.velocity.begin() + model.dimension);
  return !std::isnan(state.pressure);
}

MaterialId material_of(Case const& c, std::string const& name) {
  auto const found = std::find_if(c.materials.begin(), c.materials.end(),
                                  [&](MaterialSpec const& m) { return m.name == name; });
  return static_cast<MaterialId>(found - c.materials.begin());
}

GaugeReader point_reader(Case const& c, GaugeSpec const& gauge) {
  GaugeReader reader{gauge.name, {}, {}};
  add_point_columns(reader.columns, gauge.name, c.dimension);
  reader.read = [place = gauge.position](ReadingContext const& at, std::vector<double>& row) {
    return read_point(at.simulation, place, row);
  };
  return reader;
}

GaugeReader line_reader(Case const& c, GaugeSpec const& gauge) {
  GaugeReader reader{gauge.name, {}, {}};
  std::vector<Vec3> places;
  int const count = gauge.probe.line_points;
  for (int k = 0; k < count; ++k) {
    double const share = static_cast<double>(k) / (count - 1);
    places.push_back(
        add(scale(1.0 - share, gauge.probe.line_from), scale(share, gauge.probe.line_to)));
    add_point_columns(reader.columns, fmt::format("{}[{}]", gauge.name, k + 1), c.dimension);
  }
  reader.read = [places](ReadingContext const& at, std::vector<double>& row) {
    bool seen = false;
    for (Vec3 const& place : places) seen = read_point(at.simulation, place, row) || seen;
    return seen;
  };
  return reader;
}

GaugeReader front_reader(Case const& c, GaugeSpec const& gauge) {
  auto const read = [material = material_of(c, gauge.material), axis = gauge.axis,
                     direction = gauge.direction](ReadingContext const& at,
                                                  std::vector<double>& row) {
    row.push_back(probe_front(at.simulation.particles(), material, axis, direction));
    return !std::isnan(row.back());
  };
  return {gauge.name, {{gauge.name + " front", "m"}}, read};
}

GaugeReader level_reader(Case const&, GaugeSpec const& gauge) {
  Line const line{gauge.probe.level_from, gauge.probe.level_to};
  auto const read = [line](ReadingContext const& at, std::vector<double>& row) {
    Model const& model = at.simulation.model();
    row.push_back(probe_level(at.simulation.particles(), at.simulation.search(),
                              model.numerics.kernel, model.numerics.smoothing_length(), line));
    return !std::isnan(row.back());
  };
  return {gauge.name, {{gauge.name + " level", "m"}}, read};
}

GaugeReader wall_reader(Case const& c, GaugeSpec const& gauge) {
  GaugeReader reader{gauge.name, {}, {}};
  add_vector_columns(reader.columns, gauge.name + " force", c.dimension, "N");
  std::size_t const first_torque = c.dimension == 3 ? 0 : c.dimension == 2 ? 2 : 3;
  for (std::size_t axis = first_torque; axis < 3; ++axis)
    reader.columns.push_back({fmt::format("{} torque_{}", gauge.name, axis_letter[axis]), "N m"});
  reader.columns.push_back({gauge.name + " mean_pressure", "Pa"});
  reader.columns.push_back({gauge.name + " largest_pressure", "Pa"});
  std::string const area = c.dimension == 3 ? "m^2" : c.dimension == 2 ? "m" : "";
  reader.columns.push_back({gauge.name + " wet_area", area});
  WallPart part{wall_members(c, gauge), gauge.probe.about, face_parts(c, gauge)};
  reader.read = [part, first_torque](ReadingContext const& at, std::vector<double>& row) {
    Model const& model = at.simulation.model();
    if (!at.loads_known) {
      auto const columns = static_cast<std::size_t>(model.dimension) + (3 - first_torque) + 3;
      row.insert(row.end(), columns, std::numeric_limits<double>::quiet_NaN());
      return false;
    }
    WallReading const load = probe_wall(
        {at.simulation.particles(), at.simulation.search(), model.walls, at.loads, model.gravity,
         model.numerics.spacing, model.symmetry, model.domain_min, model.domain_max,
         at.mirror_loads, model.numerics.smoothing_length(), model.numerics.kernel},
        part);
    row.insert(row.end(), load.force.begin(), load.force.begin() + model.dimension);
    row.insert(row.end(), load.torque.begin() + static_cast<std::ptrdiff_t>(first_torque),
               load.torque.end());
    row.insert(row.end(), {load.mean_pressure, load.largest_pressure, load.wet_area});
    return load.wet_area > 0.0;
  };
  return reader;
}

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

}  // namespace

GaugeReader make_gauge_reader(Case const& c, GaugeSpec const& gauge) {
  using Make = GaugeReader (*)(Case const&, GaugeSpec const&);
  constexpr std::array<Make, 8> makers{point_reader, front_reader, wall_reader, line_reader,
                                       level_reader, sums_reader,  side_reader, budget_reader};
  return makers[static_cast<std::size_t>(gauge.kind)](c, gauge);
}

}  // namespace moraine
