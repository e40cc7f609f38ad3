// The table of parameters: walls.
#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

Parameter wall_corner(std::string_view key, std::string_view form, std::string_view meaning) {
  return {.section = Section::wall,
          .key = key,
          .type = ValueType::vector,
          .quantity = Quantity::length,
          .presence = Presence::required,
          .when_key = "form",
          .when_value = form,
          .meaning = meaning};
}

// The same box is written under the name of its form, and read back under that name only.
template <WallForm form, auto Corner>
Entry<WallSpec> form_member(Parameter parameter) {
  Entry<WallSpec> entry = member<WallSpec, &WallSpec::box, Corner>(std::move(parameter));
  entry.get = [](WallSpec const& wall) {
    return wall.form == form ? Value(wall.box.*Corner) : Value();
  };
  return entry;
}

/// An entry of the motion, written only where its value says something.
template <auto Member>
Entry<WallSpec> motion_entry(Parameter parameter) {
  parameter.section = Section::wall;
  Entry<WallSpec> entry = member<WallSpec, &WallSpec::motion, Member>(std::move(parameter));
  entry.get = [](WallSpec const& wall) {
    bool const said = wall.motion.*Member != MotionSpec{}.*Member;
    return said ? binding::load(wall.motion.*Member) : Value();
  };
  return entry;
}

void add_motion_entries(std::vector<Entry<WallSpec>>& table) {
  table.push_back(motion_entry<&MotionSpec::translation>(
      {.key = "motion.translation",
       .type = ValueType::texts,
       .preset_note = "none",
       .meaning = "displacement along each axis in m: formulas of the time t in s, such as "
                  "\"0.05 * sin(2 * pi * t)\""}));
  table.push_back(motion_entry<&MotionSpec::rotation>(
      {.key = "motion.rotation",
       .type = ValueType::text,
       .preset_note = "none",
       .meaning = "angle in rad, right-handed: a formula of the time t in s"}));
  table.push_back(motion_entry<&MotionSpec::about>(
      {.key = "motion.about",
       .type = ValueType::vector,
       .quantity = Quantity::length,
       .preset = Point{},
       .meaning =
           "point of the axis that the wall turns about; it takes part in the translation"}));
  table.push_back(motion_entry<&MotionSpec::axis>(
      {.key = "motion.axis",
       .type = ValueType::vector,
       .preset_note = "z",
       .meaning = "3D: direction of the axis of the rotation, of any length"}));
  table.push_back(motion_entry<&MotionSpec::file>(
      {.key = "motion.file",
       .type = ValueType::text,
       .preset_note = "none",
       .meaning = "CSV file with columns time (s) and x, y, z (m) or angle (rad); its path counts "
                  "from the case file"}));
}

void add_method_entries(std::vector<Entry<WallSpec>>& table) {
  table.push_back(member<WallSpec, &WallSpec::method>(
      {.section = Section::wall,
       .key = "method",
       .type = ValueType::choice,
       .preset = static_cast<int>(WallMethod::dummy),
       .names = {"dummy", "mirror", "repulsive", "mirror_and_repulsive"},
       .meaning = "what the wall is made of: layers of dummy particles behind its faces; mirror "
                  "images of the fluid, at containers at rest; a row of particles on its faces "
                  "that push; both of these (docs/walls.md)"}));
  table.push_back(member<WallSpec, &WallSpec::repulsion>(
      {.section = Section::wall,
       .key = "repulsion",
       .quantity = Quantity::specific_energy,
       .preset_note = "must be given where the method pushes",
       .limits = Limits::positive(),
       .meaning = "D of the repulsion D ((r0/r)^12 - (r0/r)^4) / r, in m^2/s^2: of the order of "
                  "the largest speed squared, such as 5 g H in tanks, or c^2",
       .source = "Monaghan, J. Comput. Phys. 110 (1994) 399, section 4"}));
  table.push_back(member<WallSpec, &WallSpec::repulsion_range>(
      {.section = Section::wall,
       .key = "repulsion_range",
       .quantity = Quantity::length,
       .preset_note = "half the spacing, where the method pushes",
       .limits = Limits::positive(),
       .meaning = "r0, the distance from which on wall particles push; more than half the spacing "
                  "pushes at the start"}));
}

std::vector<Entry<WallSpec>> make_wall_table() {
  std::vector<Entry<WallSpec>> table;
  table.push_back(
      member<WallSpec, &WallSpec::name>({.section = Section::wall,
                                         .key = "name",
                                         .type = ValueType::text,
                                         .presence = Presence::required,
                                         .meaning = "unique name, used in messages and output"}));
  table.push_back(member<WallSpec, &WallSpec::form>(
      {.section = Section::wall,
       .key = "form",
       .type = ValueType::shape_key,
       .presence = Presence::required,
       .names = {"container", "solid"},
       .meaning = "a box with the fluid inside of it, or outside"}));
  table.push_back(form_member<WallForm::container, &Box::min>(
      wall_corner("container.min", "container", "lower corner of the box around the fluid")));
  table.push_back(form_member<WallForm::container, &Box::max>(
      wall_corner("container.max", "container", "upper corner of the box around the fluid")));
  table.push_back(form_member<WallForm::solid, &Box::min>(
      wall_corner("solid.min", "solid", "lower corner of the solid box")));
  table.push_back(form_member<WallForm::solid, &Box::max>(
      wall_corner("solid.max", "solid", "upper corner of the solid box")));
  table.push_back(member<WallSpec, &WallSpec::open>({.section = Section::wall,
                                                     .key = "open",
                                                     .type = ValueType::sides,
                                                     .preset = std::vector<int>{},
                                                     .meaning = "sides without a wall"}));
  table.push_back(member<WallSpec, &WallSpec::slip>(
      {.section = Section::wall,
       .key = "slip",
       .type = ValueType::choice,
       .preset = static_cast<int>(Slip::free),
       .names = {"free", "none"},
       .meaning = "free: the fluid slides along the wall; none: it sticks"}));
  add_method_entries(table);
  add_motion_entries(table);
  return table;
}

}  // namespace

std::span<Entry<WallSpec> const> wall_entries() {
  static std::vector<Entry<WallSpec>> const table = make_wall_table();
  return table;
}

}  // namespace moraine
