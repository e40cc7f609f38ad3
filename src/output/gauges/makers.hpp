// The readers of all kinds of gauges, one function each; make_gauge_reader chooses.
#pragma once

#include "output/gauge_reader.hpp"

namespace moraine {

GaugeReader point_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader front_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader wall_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader line_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader level_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader sums_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader side_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader budget_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader crater_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader deposit_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader bubble_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader rise_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader expression_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader particle_reader(Case const& c, GaugeSpec const& gauge);
GaugeReader plane_reader(Case const& c, GaugeSpec const& gauge);

}  // namespace moraine
