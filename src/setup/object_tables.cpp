// The table of parameters: regions and gauges.
#include <vector>

#include "setup/parameter_table.hpp"
#include "setup/probe_entry.hpp"
#include "setup/probe_table.hpp"
#include "setup/region_table.hpp"
#include "setup/shape_table.hpp"

namespace moraine {
namespace {

Parameter name_of(Section section) {
  return {.section = section,
          .key = "name",
          .type = ValueType::text,
          .presence = Presence::required,
          .meaning = "unique name, used in messages and output"};
}

Parameter length_vector(Section section, std::string_view key, std::string_view meaning) {
  return {.section = section,
          .key = key,
          .type = ValueType::vector,
          .quantity = Quantity::length,
          .presence = Presence::required,
          .meaning = meaning};
}

void add_initial_state(std::vector<Entry<RegionSpec>>& table) {
  constexpr auto initial = &RegionSpec::initial;
  table.push_back(
      member<RegionSpec, initial, &InitialState::velocity>({.section = Section::region,
                                                            .key = "velocity",
                                                            .type = ValueType::vector,
                                                            .quantity = Quantity::velocity,
                                                            .preset = Point{},
                                                            .meaning = "initial velocity"}));
  table.push_back(member<RegionSpec, initial, &InitialState::density>(
      {.section = Section::region,
       .key = "density",
       .quantity = Quantity::density,
       .preset_note = "solved for the pressure where one is given, else the reference density",
       .limits = Limits::positive(),
       .meaning = "initial density"}));
  table.push_back(member<RegionSpec, initial, &InitialState::specific_energy>(
      {.section = Section::region,
       .key = "specific_energy",
       .quantity = Quantity::specific_energy,
       .preset_note = "solved where pressure and density are given, else the reference energy",
       .meaning = "initial internal energy per mass"}));
  table.push_back(member<RegionSpec, initial, &InitialState::pressure>(
      {.section = Section::region,
       .key = "pressure",
       .quantity = Quantity::pressure,
       .preset_note = "from density and energy",
       .meaning = "initial pressure; solved for the density, or the energy if density is given"}));
  table.push_back(member<RegionSpec, initial, &InitialState::hydrostatic_level>(
      {.section = Section::region,
       .key = "hydrostatic_level",
       .quantity = Quantity::length,
       .preset_note = "no hydrostatic pressure",
       .meaning = "height of the free surface against gravity; "
                  "pressure reference_density * gravity * depth, the density is solved for it"}));
}

std::vector<Entry<RegionSpec>> make_region_table() {
  std::vector<Entry<RegionSpec>> table;
  table.push_back(member<RegionSpec, &RegionSpec::name>(name_of(Section::region)));
  table.push_back(member<RegionSpec, &RegionSpec::material>({.section = Section::region,
                                                             .key = "material",
                                                             .type = ValueType::text,
                                                             .preset_note = "given by layers",
                                                             .unless_key = "layers.materials",
                                                             .meaning = "name of a material"}));
  add_shape_entries(table, Section::region);
  add_layer_entries(table);
  add_spacing_entries(table);
  add_initial_state(table);
  add_start_entries(table);
  return table;
}

Entry<GaugeSpec> front_side() {
  return {{.section = Section::gauge,
           .key = "axis",
           .type = ValueType::side,
           .preset = 1,
           .when_key = "kind",
           .when_value = "front",
           .meaning = "direction in which the farthest particle is sought"},
          [](GaugeSpec& gauge, Value const& value) {
            gauge.axis = std::get<int>(value) / 2;
            gauge.direction = std::get<int>(value) % 2 == 1 ? +1 : -1;
          },
          [](GaugeSpec const& gauge) -> Value {
            if (gauge.kind != GaugeKind::front) return {};
            return 2 * gauge.axis + (gauge.direction > 0 ? 1 : 0);
          }};
}

template <GaugeKind kind>
Entry<GaugeSpec> position_of(std::string_view meaning) {
  Parameter position = length_vector(Section::gauge, "position", meaning);
  position.when_key = "kind";
  position.when_value = name_of(kind);
  Entry<GaugeSpec> place = member<GaugeSpec, &GaugeSpec::position>(std::move(position));
  place.get = [](GaugeSpec const& gauge) {
    return gauge.kind == kind ? Value(gauge.position) : Value();
  };
  return place;
}

std::vector<Entry<GaugeSpec>> make_gauge_table() {
  std::vector<Entry<GaugeSpec>> table;
  table.push_back(member<GaugeSpec, &GaugeSpec::name>(name_of(Section::gauge)));
  table.push_back(member<GaugeSpec, &GaugeSpec::kind>(
      {.section = Section::gauge,
       .key = "kind",
       .type = ValueType::choice,
       .preset = static_cast<int>(GaugeKind::point),
       .names = {gauge_kind_names.begin(), gauge_kind_names.end()},
       .meaning =
           "point: state at a fixed place; front: farthest particle of a material; wall: "
           "load on a wall; line: states along a line; level: height of the free surface; "
           "sums: energies and momentum of a material; side: what left through a side of "
           "the domain; budget: where energy goes; crater: size of a crater; deposit: run-out "
           "and height of what slid; bubble: volume and place of a gas; rise: of the highest "
           "surface since the start; expression: a formula over particles; plane: fields on "
           "a grid, written with the frames; particle: state of one particle, which it moves "
           "with"}));
  table.push_back(position_of<GaugeKind::point>("place of the gauge"));
  table.push_back(
      position_of<GaugeKind::particle>("place whose nearest particle is followed from the start"));
  Entry<GaugeSpec> material =
      member<GaugeSpec, &GaugeSpec::material>({.section = Section::gauge,
                                               .key = "material",
                                               .type = ValueType::text,
                                               .presence = Presence::required,
                                               .when_key = "kind",
                                               .when_value = "front",
                                               .meaning = "name of a material"});
  material.get = [](GaugeSpec const& gauge) {
    return gauge.kind == GaugeKind::front ? Value(gauge.material) : Value();
  };
  table.push_back(std::move(material));
  table.push_back(front_side());
  add_probe_entries(table);
  return table;
}

}  // namespace

std::span<Entry<RegionSpec> const> region_entries() {
  static std::vector<Entry<RegionSpec>> const table = make_region_table();
  return table;
}

std::span<Entry<GaugeSpec> const> gauge_entries() {
  static std::vector<Entry<GaugeSpec>> const table = make_gauge_table();
  return table;
}

}  // namespace moraine
