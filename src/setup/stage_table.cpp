// The table of parameters: stages.
#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

Parameter optional_number(std::string_view key, Quantity quantity, std::string_view note,
                          std::string_view meaning) {
  return {.section = Section::stage,
          .key = key,
          .quantity = quantity,
          .preset_note = note,
          .limits = Limits::not_negative(),
          .meaning = meaning};
}

Parameter optional_name(std::string_view key, std::string_view meaning) {
  return {.section = Section::stage,
          .key = key,
          .type = ValueType::text,
          .preset_note = "none",
          .meaning = meaning};
}

void add_until(std::vector<Entry<StageSpec>>& table) {
  constexpr auto until = &StageSpec::until;
  table.push_back(member<StageSpec, until, &UntilSpec::after>(optional_number(
      "until.after", Quantity::time, "not by time", "ends this long after it began")));
  Parameter speed = optional_number("until.rms_speed_below", Quantity::velocity, "not by speed",
                                    "ends when sqrt(2 kinetic energy / mass) is below this");
  speed.limits = Limits::positive();
  table.push_back(member<StageSpec, until, &UntilSpec::rms_speed_below>(std::move(speed)));
  table.push_back(member<StageSpec, until, &UntilSpec::steady_for>(
      optional_number("until.steady_for", Quantity::time, "required with until.rms_speed_below",
                      "how long the speed must have stayed below; longer than a swing takes")));
  table.push_back(member<StageSpec, until, &UntilSpec::gauge>(
      optional_name("until.gauge", "name of a point gauge whose pressure ends the stage")));
  Parameter above = optional_number("until.pressure_above", Quantity::pressure, "not by pressure",
                                    "ends when the gauge reads more");
  above.limits = Limits::none();
  Parameter below = optional_number("until.pressure_below", Quantity::pressure, "not by pressure",
                                    "ends when the gauge reads less");
  below.limits = Limits::none();
  table.push_back(member<StageSpec, until, &UntilSpec::pressure_above>(std::move(above)));
  table.push_back(member<StageSpec, until, &UntilSpec::pressure_below>(std::move(below)));
}

std::vector<Entry<StageSpec>> make_stage_table() {
  std::vector<Entry<StageSpec>> table;
  table.push_back(
      member<StageSpec, &StageSpec::name>({.section = Section::stage,
                                           .key = "name",
                                           .type = ValueType::text,
                                           .presence = Presence::required,
                                           .meaning = "unique name, used in messages"}));
  Parameter damping = optional_number("damping_time", Quantity::time, "no damping",
                                      "velocities fall by a factor e in this time");
  damping.limits = Limits::positive();
  table.push_back(member<StageSpec, &StageSpec::damping_time>(std::move(damping)));
  table.push_back(member<StageSpec, &StageSpec::remove_wall>(optional_name(
      "remove_wall", "name of a wall that is gone from the start of the stage: a gate")));
  table.push_back(member<StageSpec, &StageSpec::detonate>(optional_name(
      "detonate",
      "name of a region whose particles become another material when the stage starts")));
  table.push_back(member<StageSpec, &StageSpec::into>(optional_name(
      "into", "name of that material; density stays, energy is its reference energy")));
  add_until(table);
  return table;
}

}  // namespace

std::span<Entry<StageSpec> const> stage_entries() {
  static std::vector<Entry<StageSpec>> const table = make_stage_table();
  return table;
}

}  // namespace moraine
