// The table of parameters: strength of solids. A law adds its keys here.
#include "setup/strength_table.hpp"

#include <utility>

#include "matter/strength/strength.hpp"

namespace moraine {
namespace {

template <auto Member>
Entry<MaterialSpec> entry(Parameter parameter) {
  parameter.section = Section::material;
  return member<MaterialSpec, &MaterialSpec::strength, Member>(std::move(parameter));
}

template <auto Member>
Entry<MaterialSpec> constant(std::string_view key, Quantity quantity, Limits limits,
                             std::string_view of, std::string_view meaning) {
  return entry<Member>(
      {.key = key, .quantity = quantity, .preset_note = of, .limits = limits, .meaning = meaning});
}

Entry<MaterialSpec> kind() {
  Entry<MaterialSpec> made = entry<&StrengthSpec::kind>(
      {.key = "strength.kind",
       .type = ValueType::choice,
       .preset_note = "that of the shipped material, or none: a fluid",
       .names = std::vector<std::string_view>(strength_names.begin(), strength_names.end()),
       .meaning = "how a solid resists shear; the pressure is that of eos",
       .source = "docs/theory/strength.md"});
  made.get = [](MaterialSpec const& material) {
    return material.strength.kind == StrengthKind::none
               ? Value()
               : Value(static_cast<int>(material.strength.kind));
  };
  return made;
}

}  // namespace

void add_strength_entries(std::vector<Entry<MaterialSpec>>& table) {
  using S = StrengthSpec;
  constexpr double right_angle = 1.5707963267948966;
  table.push_back(member<MaterialSpec, &MaterialSpec::tension>(
      {.section = Section::material,
       .key = "tension",
       .type = ValueType::choice,
       .preset_note = "that of the shipped material, or floor",
       .names = {"floor", "spall"},
       .meaning =
           "what becomes of the material at least_pressure: the pressure stays there, or the "
           "material parts and bears neither tension nor, in tension, shear any more"}));
  table.push_back(kind());
  table.push_back(constant<&S::shear_modulus>("strength.shear_modulus", Quantity::pressure,
                                              Limits::positive(), "none; all kinds need it",
                                              "shear modulus G"));
  table.push_back(constant<&S::yield_strength>(
      "strength.yield_strength", Quantity::pressure, Limits::positive(), "none; von_mises needs it",
      "strength in uniaxial tension; sqrt(J2) <= this / sqrt(3)"));
  table.push_back(constant<&S::yield_slope>(
      "strength.yield_slope", Quantity::number, {.min = 0.0, .max = 0.5773},
      "none; drucker_prager needs it", "alpha of sqrt(J2) <= k + 3 alpha p"));
  table.push_back(constant<&S::shear_strength>(
      "strength.shear_strength", Quantity::pressure, Limits::not_negative(),
      "none; drucker_prager needs it", "k of sqrt(J2) <= k + 3 alpha p: at zero pressure"));
  table.push_back(constant<&S::friction_angle>(
      "strength.friction_angle", Quantity::angle, {.min = 0.0, .max = right_angle * 0.98},
      "none; mohr_coulomb needs it", "angle of internal friction, \"31 deg\""));
  table.push_back(constant<&S::cohesion>("strength.cohesion", Quantity::pressure,
                                         Limits::not_negative(), "none; mohr_coulomb needs it",
                                         "shear strength without pressure on the plane"));
}

}  // namespace moraine
