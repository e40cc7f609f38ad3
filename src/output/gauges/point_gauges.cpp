// Gauges of kind point, line, front and level.
#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "output/gauges/gauge_columns.hpp"
#include "output/gauges/makers.hpp"
#include "probes/level_probe.hpp"
#include "probes/point_probe.hpp"

namespace moraine {
namespace {

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

}  // namespace

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
  auto const& origin = gauge.probe.line_origin;
  if (origin) reader.decay.emplace();
  std::vector<Vec3> places;
  int const count = gauge.probe.line_points;
  for (int k = 0; k < count; ++k) {
    double const share = static_cast<double>(k) / (count - 1);
    places.push_back(
        add(scale(1.0 - share, gauge.probe.line_from), scale(share, gauge.probe.line_to)));
    if (origin) {
      reader.decay->distances.push_back(norm(subtract(places.back(), *origin)));
      reader.decay->columns.push_back(reader.columns.size());
    }
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

}  // namespace moraine
