// The table of parameters: gauges that measure shapes, formulas and planes.
#include <utility>

#include "setup/parameter.hpp"
#include "setup/probe_entry.hpp"

namespace moraine {
namespace {

template <GaugeKind kind>
Entry<GaugeSpec> materials(Presence presence, std::string_view meaning) {
  auto entry = probe_member<kind, &ProbeSpec::materials>(
      {.key = "materials",
       .type = ValueType::texts,
       .presence = presence,
       .preset_note = presence == Presence::required ? "" : "all materials",
       .meaning = meaning});
  entry.get = [](GaugeSpec const& gauge) {
    bool const given = gauge.kind == kind && !gauge.probe.materials.empty();
    return given ? Value(gauge.probe.materials) : Value();
  };
  return entry;
}

template <GaugeKind kind>
Entry<GaugeSpec> up() {
  return probe_member<kind, &ProbeSpec::up>(
      {.key = "up",
       .type = ValueType::side,
       .preset_note = "against gravity; without gravity y+ in 2D, z+ in 3D",
       .meaning = "direction that heights are counted in: a height is the coordinate along it"});
}

template <GaugeKind kind, auto Member>
Entry<GaugeSpec> within_corner(std::string_view key, std::string_view meaning) {
  auto entry = probe_member<kind, &ProbeSpec::within, Member>({.key = key,
                                                               .type = ValueType::vector,
                                                               .quantity = Quantity::length,
                                                               .presence = Presence::with_table,
                                                               .preset_note = "the whole domain",
                                                               .meaning = meaning});
  entry.set = [](GaugeSpec& gauge, Value const& value) {
    binding::store(gauge.probe.within.*Member, value);
    gauge.probe.within.given = true;
  };
  entry.get = [](GaugeSpec const& gauge) {
    bool const given = gauge.kind == kind && gauge.probe.within.given;
    return given ? binding::load(gauge.probe.within.*Member) : Value();
  };
  return entry;
}

template <GaugeKind kind>
void add_within(std::vector<Entry<GaugeSpec>>& table) {
  table.push_back(within_corner<kind, &WithinSpec::min>(
      "within.min", "lower corner of a box: only what lies in it counts"));
  table.push_back(within_corner<kind, &WithinSpec::max>("within.max", "upper corner of that box"));
}

void add_crater(std::vector<Entry<GaugeSpec>>& table) {
  constexpr auto kind = GaugeKind::crater;
  constexpr auto crater = &ProbeSpec::crater;
  table.push_back(materials<kind>(Presence::required, "materials of the ground"));
  table.push_back(up<kind>());
  table.push_back(probe_member<kind, crater, &CraterSpec::level>(
      {.key = "crater.level",
       .quantity = Quantity::length,
       .presence = Presence::required,
       .meaning = "height of the ground before there was a crater"}));
  table.push_back(place<kind, crater, &CraterSpec::center>(
      "crater.center", "a place on the axis of the crater, at any height"));
  table.push_back(probe_member<kind, crater, &CraterSpec::radius>(
      {.key = "crater.radius",
       .quantity = Quantity::length,
       .preset_note = "to the end of the domain",
       .limits = Limits::positive(),
       .meaning = "how far from the axis ground is looked at"}));
  table.push_back(probe_member<kind, crater, &CraterSpec::sectors>(
      {.key = "crater.sectors",
       .type = ValueType::integer,
       .preset = 16,
       .limits = Limits::between(4.0, 360.0),
       .meaning = "number of directions round the axis in 3D that are averaged; in 2D there are "
                  "the two sides"}));
}

void add_deposit(std::vector<Entry<GaugeSpec>>& table) {
  constexpr auto kind = GaugeKind::deposit;
  constexpr auto deposit = &ProbeSpec::deposit;
  table.push_back(materials<kind>(Presence::required, "materials that slide"));
  table.push_back(up<kind>());
  table.push_back(probe_member<kind, deposit, &DepositSpec::base>(
      {.key = "deposit.base",
       .quantity = Quantity::length,
       .presence = Presence::required,
       .meaning = "height of the floor that the thickness is counted from"}));
  table.push_back(probe_member<kind, deposit, &DepositSpec::along>(
      {.key = "deposit.along",
       .type = ValueType::side,
       .preset_note = "round about: the horizontal distance from the origin",
       .meaning = "direction of the run-out"}));
  table.push_back(probe_member<kind, deposit, &DepositSpec::origin>(
      {.key = "deposit.origin",
       .type = ValueType::vector,
       .quantity = Quantity::length,
       .preset_note = "the origin of the coordinates; must be given without along",
       .meaning = "place that the run-out is counted from"}));
}

void add_expression(std::vector<Entry<GaugeSpec>>& table) {
  constexpr auto kind = GaugeKind::expression;
  constexpr auto expression = &ProbeSpec::expression;
  table.push_back(probe_member<kind, expression, &ExpressionSpec::formula>(
      {.key = "formula",
       .type = ValueType::text,
       .presence = Presence::required,
       .meaning = "formula of the fields of a particle, in SI units: x, y, z, velocity_x, "
                  "velocity_y, velocity_z, speed, density, pressure, specific_energy, "
                  "sound_speed, mass, volume, smoothing_length, burn_fraction, distension, "
                  "stress_xx ... stress_yz, shear_stress, plastic_strain, plastic_work, time"}));
  table.push_back(probe_member<kind, expression, &ExpressionSpec::reduce>(
      {.key = "reduce",
       .type = ValueType::choice,
       .presence = Presence::required,
       .names = {"max", "min", "mean", "sum", "integral"},
       .meaning = "what becomes of the values: the largest, the smallest, the weighted mean, the "
                  "sum over particles, the integral over their volume"}));
  auto weight = probe_member<kind, expression, &ExpressionSpec::weight>(
      {.key = "weight",
       .type = ValueType::choice,
       .preset = static_cast<int>(MeanWeight::mass),
       .names = {"mass", "volume", "number"},
       .meaning = "weight of each particle in a mean"});
  // It is refused beside another reduction, hence not told there either.
  weight.get = [](GaugeSpec const& gauge) {
    bool const counts = gauge.kind == kind && gauge.probe.expression.reduce == Reduction::mean;
    return counts ? binding::load(gauge.probe.expression.weight) : Value();
  };
  table.push_back(std::move(weight));
  table.push_back(probe_member<kind, expression, &ExpressionSpec::unit>(
      {.key = "unit",
       .type = ValueType::text,
       .preset_note = "none",
       .meaning = "unit of the reading, shown in tables and pictures; nothing is converted"}));
  table.push_back(materials<kind>(Presence::optional, "materials that count"));
  add_within<kind>(table);
}

void add_plane(std::vector<Entry<GaugeSpec>>& table) {
  constexpr auto kind = GaugeKind::plane;
  constexpr auto plane = &ProbeSpec::plane;
  table.push_back(place<kind, plane, &PlaneSpec::min>("plane.min", "lower corner of the grid"));
  table.push_back(place<kind, plane, &PlaneSpec::max>(
      "plane.max", "upper corner of the grid; in 3D min and max agree along one axis"));
  table.push_back(probe_member<kind, plane, &PlaneSpec::step>(
      {.key = "plane.step",
       .quantity = Quantity::length,
       .presence = Presence::required,
       .limits = Limits::positive(),
       .meaning = "about the distance of the points; made smaller so that both ends are points"}));
}

}  // namespace

void add_measure_entries(std::vector<Entry<GaugeSpec>>& table) {
  add_crater(table);
  add_deposit(table);
  table.push_back(materials<GaugeKind::bubble>(Presence::required, "materials of the gas"));
  add_within<GaugeKind::bubble>(table);
  table.push_back(materials<GaugeKind::rise>(Presence::optional, "materials with the surface"));
  table.push_back(up<GaugeKind::rise>());
  add_within<GaugeKind::rise>(table);
  add_expression(table);
  add_plane(table);
}

}  // namespace moraine
