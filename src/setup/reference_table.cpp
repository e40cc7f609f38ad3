// The table of parameters: reference values.
#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

Parameter text(std::string_view key, std::string_view note, std::string_view meaning) {
  return {.section = Section::reference,
          .key = key,
          .type = ValueType::text,
          .preset_note = note,
          .meaning = meaning};
}

Parameter needed(Parameter parameter) {
  parameter.presence = Presence::required;
  parameter.preset_note = {};
  return parameter;
}

std::vector<Entry<ReferenceSpec>> make_reference_table() {
  using Spec = ReferenceSpec;
  std::vector<Entry<Spec>> table;
  table.push_back(member<Spec, &Spec::name>(
      needed(text("name", "", "unique name, shown beside the value or curve"))));
  table.push_back(member<Spec, &Spec::gauge>(
      needed(text("gauge", "", "name of the gauge that it belongs to"))));
  table.push_back(member<Spec, &Spec::column>(
      text("column", "the first of the gauge",
           "quantity of the gauge: pressure, velocity_x, force_y ...")));
  table.push_back(member<Spec, &Spec::file>(
      text("file", "a value is given",
           "CSV file with a line of names, then time [s] and value (SI) on each line: a curve")));
  table.push_back(member<Spec, &Spec::measure>(
      {.section = Section::reference,
       .key = "measure",
       .type = ValueType::choice,
       .preset = static_cast<int>(ReadingMeasure::largest),
       .names = {"largest", "smallest", "time_of_largest", "time_of_smallest", "arrival",
                 "duration", "impulse", "integral", "last"},
       .meaning = "which number of the readings `value` is compared with"}));
  table.push_back(
      member<Spec, &Spec::value>({.section = Section::reference,
                                  .key = "value",
                                  .preset_note = "a file is given",
                                  .unless_key = "file",
                                  .meaning = "the reference value, a number in SI units"}));
  table.push_back(member<Spec, &Spec::tolerance>(
      {.section = Section::reference,
       .key = "tolerance",
       .preset_note = "compared, not judged",
       .limits = Limits::positive(),
       .meaning = "largest difference that passes, as a share of the value: 0.05 is 5 %"}));
  table.push_back(
      member<Spec, &Spec::within>({.section = Section::reference,
                                   .key = "within",
                                   .preset_note = "by tolerance",
                                   .limits = Limits::positive(),
                                   .meaning = "the same as a number in the SI unit of the value"}));
  table.push_back(member<Spec, &Spec::source>(
      needed(text("source", "", "where the value or curve comes from"))));
  return table;
}

}  // namespace

std::span<Entry<ReferenceSpec> const> reference_entries() {
  static std::vector<Entry<ReferenceSpec>> const table = make_reference_table();
  return table;
}

}  // namespace moraine
