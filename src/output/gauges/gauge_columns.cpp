#include "output/gauges/gauge_columns.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "setup/upward.hpp"

namespace moraine {

void add_vector_columns(std::vector<TableColumn>& columns, std::string const& name, int dimension,
                        std::string const& unit) {
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
    columns.push_back({fmt::format("{}_{}", name, axis_letter[axis]), unit});
}

MaterialId material_of(Case const& c, std::string const& name) {
  auto const found = std::find_if(c.materials.begin(), c.materials.end(),
                                  [&](MaterialSpec const& m) { return m.name == name; });
  return static_cast<MaterialId>(found - c.materials.begin());
}

Selection selection_of(Case const& c, GaugeSpec const& gauge) {
  Selection selection;
  for (std::string const& name : gauge.probe.materials)
    selection.materials.push_back(material_of(c, name));
  if (gauge.probe.within.given)
    selection.within = PlaceBox{gauge.probe.within.min, gauge.probe.within.max};
  return selection;
}

Upwards up_of(Case const& c, GaugeSpec const& gauge) {
  int const side = side_above(c, gauge.probe.up).value_or(2 * (c.dimension - 1) + 1);
  return {static_cast<std::size_t>(side / 2), side % 2 == 1 ? 1.0 : -1.0};
}

std::string unit_of_length(int power) {
  if (power == 0) return "";
  return power == 1 ? "m" : fmt::format("m^{}", power);
}

}  // namespace moraine
