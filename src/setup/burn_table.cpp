#include "setup/burn_table.hpp"

#include <utility>

namespace moraine {
namespace {

// An entry that is written only for a material that burns, and only where its value says something.
template <auto Member>
Entry<MaterialSpec> burn_entry(Parameter parameter) {
  parameter.section = Section::material;
  if (parameter.key != "burn.kind") {
    parameter.when_key = "burn.kind";
    parameter.when_value = "programmed";
  }
  Entry<MaterialSpec> entry =
      member<MaterialSpec, &MaterialSpec::burn, Member>(std::move(parameter));
  entry.get = [](MaterialSpec const& material) {
    bool const burns = material.burn.kind == BurnKind::programmed;
    bool const said = material.burn.*Member != BurnSpec{}.*Member;
    return burns && said ? binding::load(material.burn.*Member) : Value();
  };
  return entry;
}

Parameter place(std::string_view key, std::string_view meaning) {
  return {.key = key,
          .type = ValueType::vector,
          .quantity = Quantity::length,
          .presence = Presence::with_table,
          .meaning = meaning};
}

}  // namespace

void add_burn_entries(std::vector<Entry<MaterialSpec>>& table) {
  table.push_back(burn_entry<&BurnSpec::kind>(
      {.key = "burn.kind",
       .type = ValueType::choice,
       .preset = static_cast<int>(BurnKind::instantaneous),
       .names = {"instantaneous", "programmed"},
       .meaning = "how an explosive (jwl, ideal_gas) turns into products: all of it at once, or "
                  "behind a front that runs from where it is lit"}));
  table.push_back(burn_entry<&BurnSpec::detonation_velocity>(
      {.key = "burn.detonation_velocity",
       .quantity = Quantity::velocity,
       .preset_note = "that of the material; of an ideal gas, that of its Chapman-Jouguet state",
       .limits = Limits::positive(),
       .meaning = "speed of the front"}));
  table.push_back(burn_entry<&BurnSpec::cj_volume>(
      {.key = "burn.cj_volume",
       .preset_note = "that of the Chapman-Jouguet state of the equation of state",
       .limits = Limits::between(0.1, 0.99),
       .meaning = "volume of just burnt products by that of the explosive: compressed as far, it "
                  "has burnt without being lit"}));
  table.push_back(burn_entry<&BurnSpec::width_in_spacings>(
      {.key = "burn.width_in_spacings",
       .preset = BurnSpec{}.width_in_spacings,
       .limits = {.min = 0.1, .max = 100.0},
       .meaning = "width of the front, by resolution.spacing",
       .source = "after Giroux, HEMP User's Manual, UCRL-51079 (1973): some cells"}));
  table.push_back(burn_entry<&BurnSpec::delay>(
      {.key = "burn.delay",
       .quantity = Quantity::time,
       .preset = 0.0,
       .limits = Limits::not_negative(),
       .meaning = "time from the start of the run, or of the stage that detonates the charge, to "
                  "its lighting"}));
  table.push_back(burn_entry<&BurnSpec::ignition_points>(
      {.key = "burn.ignition_points",
       .type = ValueType::points,
       .quantity = Quantity::length,
       .preset_note = "none",
       .meaning = "points where it is lit; one of points, line and plane must be given"}));
  table.push_back(burn_entry<&BurnSpec::line_from>(
      place("burn.ignition_line.from", "start of a straight line that is lit all at once")));
  table.push_back(burn_entry<&BurnSpec::line_to>(place("burn.ignition_line.to", "its end")));
  table.push_back(burn_entry<&BurnSpec::plane_point>(
      place("burn.ignition_plane.point", "a point of a plane that is lit all at once")));
  Parameter normal = place("burn.ignition_plane.normal", "its normal, of any length");
  normal.quantity = Quantity::number;
  table.push_back(burn_entry<&BurnSpec::plane_normal>(std::move(normal)));
}

}  // namespace moraine
