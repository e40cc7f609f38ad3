#include "output/gauge_reader.hpp"

#include <array>

#include "output/gauges/makers.hpp"

namespace moraine {

GaugeReader make_gauge_reader(Case const& c, GaugeSpec const& gauge) {
  using Make = GaugeReader (*)(Case const&, GaugeSpec const&);
  constexpr std::array<Make, gauge_kind_count> makers{
      point_reader,  front_reader, wall_reader,       line_reader,   level_reader,
      sums_reader,   side_reader,  budget_reader,     crater_reader, deposit_reader,
      bubble_reader, rise_reader,  expression_reader, plane_reader,  particle_reader};
  return makers[static_cast<std::size_t>(gauge.kind)](c, gauge);
}

}  // namespace moraine
