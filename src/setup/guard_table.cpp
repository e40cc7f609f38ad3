#include "setup/guard_table.hpp"

#include <string>
#include <string_view>

namespace moraine {
namespace {

constexpr auto guards = &Case::guards;

/// A bound by some measure of the run; infinity: none.
Parameter bound(std::string_view key, double preset, std::string_view meaning) {
  return {.key = key,
          .preset = preset,
          .limits = {.min = 0.0, .min_excluded = true, .infinity_allowed = true},
          .meaning = meaning};
}

Parameter ratio(std::string_view key, std::string_view note, std::string_view meaning) {
  return {.key = key,
          .preset_note = note,
          .limits = {.min = 1.0, .min_excluded = true, .infinity_allowed = true},
          .meaning = meaning};
}

std::vector<std::string_view> optional_guards() {
  std::vector<std::string_view> names;
  for (GuardInfo const& guard : guard_table)
    if (guard.optional) names.push_back(guard.name);
  return names;
}

}  // namespace

void add_guards(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, guards, &GuardSettings::interval>(
      {.key = "guards.interval",
       .type = ValueType::integer,
       .preset = 20,
       .limits = Limits::between(1.0, 1e6),
       .meaning = "steps between two looks of the guards that may be switched off"}));
  table.push_back(
      member<Case, guards, &GuardSettings::off>({.key = "guards.off",
                                                 .type = ValueType::texts,
                                                 .preset = std::vector<std::string>{},
                                                 .names = optional_guards(),
                                                 .meaning = "guards that do not look"}));
  table.push_back(member<Case, guards, &GuardSettings::compression>(
      ratio("guards.compression", "3; 1000 for an ideal gas",
            "largest density of a material divided by its densest at the start")));
  table.push_back(member<Case, guards, &GuardSettings::expansion>(
      ratio("guards.expansion", "1000 (2 smoothing_factor)^dimension",
            "thinnest density of a material at the start divided by its least")));
  table.push_back(member<Case, guards, &GuardSettings::speed>(
      bound("guards.speed", 10.0,
            "largest speed divided by the largest |v| + c at the start, and a fall through the "
            "domain")));
  table.push_back(member<Case, guards, &GuardSettings::specific_energy>(
      bound("guards.specific_energy", 10.0,
            "largest change of the specific energy divided by the largest at the start, and half "
            "the square of the speed above")));
  table.push_back(member<Case, guards, &GuardSettings::wall_depth>(
      bound("guards.wall_depth", 0.5, "largest depth behind the face of a wall in spacings")));
  table.push_back(member<Case, guards, &GuardSettings::energy_budget>(
      bound("guards.energy_budget", 0.05,
            "largest change of the total energy that nothing accounts for, divided by the energy "
            "of the run")));
  Parameter step = bound("guards.time_step", 1e-3,
                         "least time step, for as many steps as the interval, divided by that of "
                         "sound at the start; 0: none");
  step.limits = Limits::between(0.0, 1.0);
  table.push_back(member<Case, guards, &GuardSettings::time_step>(std::move(step)));
}

}  // namespace moraine
