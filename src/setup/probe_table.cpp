#include "setup/probe_table.hpp"

#include "setup/probe_entry.hpp"

namespace moraine {
namespace {

// A corner of the part's box; giving it makes the part.
template <auto Member>
Entry<GaugeSpec> part_corner(std::string_view key, std::string_view meaning) {
  auto entry = probe_member<GaugeKind::wall, Member>({.key = key,
                                                      .type = ValueType::vector,
                                                      .quantity = Quantity::length,
                                                      .presence = Presence::with_table,
                                                      .preset_note = "the whole wall",
                                                      .meaning = meaning});
  entry.set = [](GaugeSpec& gauge, Value const& value) {
    binding::store(gauge.probe.*Member, value);
    gauge.probe.has_part = true;
  };
  entry.get = [](GaugeSpec const& gauge) {
    bool const given = gauge.kind == GaugeKind::wall && gauge.probe.has_part;
    return given ? binding::load(gauge.probe.*Member) : Value();
  };
  return entry;
}

void add_wall(std::vector<Entry<GaugeSpec>>& table) {
  table.push_back(probe_member<GaugeKind::wall, &ProbeSpec::wall>(
      {.key = "wall",
       .type = ValueType::text,
       .presence = Presence::required,
       .meaning = "name of the wall whose load is measured"}));
  table.push_back(part_corner<&ProbeSpec::part_min>(
      "part.min", "lower corner of a box: places of the wall's faces in it count"));
  table.push_back(part_corner<&ProbeSpec::part_max>("part.max", "upper corner of that box"));
  table.push_back(probe_member<GaugeKind::wall, &ProbeSpec::about>(
      {.key = "about",
       .type = ValueType::vector,
       .quantity = Quantity::length,
       .preset = Point{},
       .meaning = "point that the torque is taken about"}));
}

void add_line(std::vector<Entry<GaugeSpec>>& table) {
  table.push_back(place<GaugeKind::line, &ProbeSpec::line_from>("line.from", "first point"));
  table.push_back(place<GaugeKind::line, &ProbeSpec::line_to>("line.to", "last point"));
  table.push_back(probe_member<GaugeKind::line, &ProbeSpec::line_points>(
      {.key = "line.points",
       .type = ValueType::integer,
       .preset = 11,
       .limits = Limits::between(2.0, 1000.0),
       .meaning = "number of points at equal distances, both ends included"}));
  table.push_back(probe_member<GaugeKind::line, &ProbeSpec::line_origin>(
      {.key = "line.origin",
       .type = ValueType::vector,
       .quantity = Quantity::length,
       .preset_note = "no exponent",
       .meaning = "place that distances are counted from: the summary then tells the exponent with "
                  "which peaks of pressure fall off with the distance"}));
}

}  // namespace

void add_probe_entries(std::vector<Entry<GaugeSpec>>& table) {
  add_wall(table);
  add_line(table);
  table.push_back(place<GaugeKind::level, &ProbeSpec::level_from>(
      "level.from", "end of the line that lies in the fluid"));
  table.push_back(place<GaugeKind::level, &ProbeSpec::level_to>(
      "level.to", "end of the line above the highest surface expected"));
  table.push_back(probe_member<GaugeKind::sums, &ProbeSpec::of>(
      {.key = "of",
       .type = ValueType::text,
       .presence = Presence::required,
       .meaning = "name of the material whose energies and momentum are summed"}));
  table.push_back(probe_member<GaugeKind::side, &ProbeSpec::side>(
      {.key = "side",
       .type = ValueType::side,
       .presence = Presence::required,
       .meaning = "side of the domain through which particles leave"}));
  add_measure_entries(table);
}

}  // namespace moraine
