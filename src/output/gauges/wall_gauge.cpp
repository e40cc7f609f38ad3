// Gauges of kind wall.
#include <fmt/core.h>

#include <limits>
#include <utility>

#include "output/gauges/gauge_columns.hpp"
#include "output/gauges/makers.hpp"
#include "setup/wall_parts.hpp"

namespace moraine {

GaugeReader wall_reader(Case const& c, GaugeSpec const& gauge) {
  GaugeReader reader{gauge.name, {}, {}};
  add_vector_columns(reader.columns, gauge.name + " force", c.dimension, "N");
  std::size_t const first_torque = c.dimension == 3 ? 0 : c.dimension == 2 ? 2 : 3;
  for (std::size_t axis = first_torque; axis < 3; ++axis)
    reader.columns.push_back({fmt::format("{} torque_{}", gauge.name, axis_letter[axis]), "N m"});
  reader.columns.push_back({gauge.name + " mean_pressure", "Pa"});
  reader.columns.push_back({gauge.name + " largest_pressure", "Pa"});
  reader.columns.push_back({gauge.name + " wet_area", unit_of_length(c.dimension - 1)});
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

}  // namespace moraine
