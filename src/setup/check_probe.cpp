#include "setup/check_probe.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/input_error.hpp"
#include "setup/check_measures.hpp"
#include "setup/geometry.hpp"
#include "setup/parameter.hpp"

namespace moraine {
namespace {

template <class Spec>
void check_name(std::vector<Spec> const& specs, std::string const& name, std::string const& key,
                std::string_view what, Source& source) {
  if (!source.good(key)) return;
  std::vector<std::string_view> names;
  for (auto const& spec : specs) names.push_back(spec.name);
  if (std::find(names.begin(), names.end(), name) == names.end())
    source.report_value(key, fmt::format("is not a {} of this case", what), name_hint(name, names));
}

/// The keys and ends of the line that a gauge of kind line or level has.
struct Ends {
  std::string from_key, to_key;
  Point from, to;
};

Ends ends_of(GaugeSpec const& gauge, std::string const& key) {
  if (gauge.kind == GaugeKind::line)
    return {key + ".line.from", key + ".line.to", gauge.probe.line_from, gauge.probe.line_to};
  return {key + ".level.from", key + ".level.to", gauge.probe.level_from, gauge.probe.level_to};
}

void check_part(Case const& c, ProbeSpec const& probe, std::string const& key, Source& source) {
  if (!source.good(key + ".min") || !source.good(key + ".max")) return;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    if (!(probe.part_min[axis] < probe.part_max[axis]))
      source.report_value(key + ".max",
                          fmt::format("must be greater than min along {}", axis_names[axis]));
}

/// Distances of a power law must differ.
void check_decay(GaugeSpec const& gauge, std::string const& key, Source& source) {
  std::string const origin_key = key + ".line.origin";
  auto const& origin = gauge.probe.line_origin;
  if (gauge.kind != GaugeKind::line || !origin || !source.good(origin_key)) return;
  if (!source.good(key + ".line.from") || !source.good(key + ".line.to")) return;
  double const first = norm(subtract(gauge.probe.line_from, *origin));
  double const last = norm(subtract(gauge.probe.line_to, *origin));
  if (gauge.probe.line_points == 2 && first == last)
    source.report_value(origin_key, "is as far from one end of the line as from the other",
                        "choose another origin, or more points");
}

void check_side(Case const& c, ProbeSpec const& probe, std::string const& key, Source& source) {
  auto const axis = static_cast<std::size_t>(probe.side / 2);
  if (source.good(key) && c.periodic[axis])
    source.report_value(key, fmt::format("is a side that nothing leaves through: the domain "
                                         "repeats itself along {}",
                                         axis_names[axis]));
}

}  // namespace

void check_probe(Case const& c, GaugeSpec const& gauge, std::string const& key, Source& source) {
  if (gauge.kind == GaugeKind::wall) {
    check_name(c.walls, gauge.probe.wall, key + ".wall", "wall", source);
    check_part(c, gauge.probe, key + ".part", source);
  } else if (gauge.kind == GaugeKind::sums) {
    check_name(c.materials, gauge.probe.of, key + ".of", "material", source);
  } else if (gauge.kind == GaugeKind::side) {
    check_side(c, gauge.probe, key + ".side", source);
  } else if (gauge.kind == GaugeKind::line || gauge.kind == GaugeKind::level) {
    Ends const ends = ends_of(gauge, key);
    if (source.good(ends.from_key) && source.good(ends.to_key) && ends.from == ends.to)
      source.report_value(ends.to_key, "is the place where the line begins");
    check_decay(gauge, key, source);
  } else {
    check_measure(c, gauge, key, source);
  }
}

void check_probe_places(Case const& c, GaugeSpec const& gauge, std::string const& key,
                        Source& source) {
  check_measure_places(c, gauge, key, source);
  if (gauge.kind != GaugeKind::line && gauge.kind != GaugeKind::level) return;
  Ends const ends = ends_of(gauge, key);
  for (auto const& [end, end_key] :
       {std::pair(ends.from, ends.from_key), std::pair(ends.to, ends.to_key)})
    if (source.good(end_key) && !is_inside({end, end}, c.domain, c.dimension))
      source.report_value(end_key, "is outside the domain");
}

}  // namespace moraine
