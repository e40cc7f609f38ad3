// The reference page, written from the table of parameters and the shipped materials.
#include <fmt/core.h>

#include <string>
#include <vector>

#include "setup/explain.hpp"
#include "setup/materials.hpp"
#include "setup/parameter_table.hpp"
#include "setup/parameter_text.hpp"

namespace moraine {
namespace {

constexpr std::string_view introduction =
    R"(# Reference of the case file

This page is made by the program: `moraine explain --reference > docs/reference.md`. A test fails
when it is out of date. `moraine explain KEY` says the same of one key, `moraine schema` writes it as
a JSON Schema for editors. The [case guide](case-guide.md) tells how to use it.

A number is in SI units; a text carries its unit, `"4 cm"`. In 2D, masses and energies are per metre
of thickness, in 1D per square metre.
)";

// A vertical bar would end the cell.
std::string cell(std::string const& text) {
  std::string result;
  for (char const c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string row(Parameter const& parameter) {
  std::string meaning(parameter.meaning);
  if (std::string const condition = condition_text(parameter); !condition.empty())
    meaning += fmt::format(" (where {})", condition);
  if (!parameter.source.empty()) meaning += fmt::format(". Source: {}", parameter.source);
  std::string const key = parameter.type == ValueType::shape_key
                              ? fmt::format("*{}*", parameter.key)
                              : fmt::format("`{}`", parameter.key);
  std::string const example = example_value(parameter);
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", key, cell(meaning),
                     cell(unit_text(parameter)), cell(default_text(parameter)),
                     cell(range_text(parameter)),
                     example.empty() ? "" : fmt::format("`{}`", cell(example)));
}

std::string heading(SectionInfo const& section) {
  if (section.repeat == Repeat::named)
    return fmt::format("\n## `[{}.NAME]`\n\n{}.\n", section.key, section.meaning);
  if (section.repeat == Repeat::list)
    return fmt::format("\n## `[[{}]]`\n\n{}.\n", section.key, section.meaning);
  return fmt::format("\n## The whole case\n\n{}.\n", section.meaning);
}

std::string section_text(SectionInfo const& section) {
  std::string text = heading(section);
  text += "\n| key | meaning | unit | default | valid | example |\n|---|---|---|---|---|---|\n";
  for (auto const* parameter : all_parameters())
    if (parameter->section == section.section) text += row(*parameter);
  return text;
}

std::string quantities_text() {
  std::string text =
      "\n## Quantities and units\n\nAny unit that UDUNITS-2 knows, and `g0` (standard gravity, "
      "9.80665 m/s^2) and `deg` (degree).\n\n| quantity | SI unit | usual units |\n|---|---|---|\n";
  for (std::size_t i = 0; i < quantity_count; ++i) {
    auto const& quantity = info(static_cast<Quantity>(i));
    std::string usual;
    for (auto const unit : quantity.usual)
      if (!unit.empty()) usual += fmt::format("{}`{}`", usual.empty() ? "" : ", ", unit);
    text += fmt::format("| {} | {} | {} |\n", quantity.name, quantity.unit, usual);
  }
  return text;
}

std::string materials_text() {
  std::string text =
      "\n## Materials for `use`\n\n`moraine materials NAME` prints all values with their "
      "sources.\n\n| name | equation of state | meaning |\n|---|---|---|\n";
  for (auto const& material : shipped_materials())
    text += fmt::format("| `{}` | `{}` | {} |\n", material.spec.name, eos_name(material.spec.eos),
                        cell(material.meaning));
  return text;
}

}  // namespace

std::string reference_page() {
  std::string text(introduction);
  for (auto const& section : section_table) text += section_text(section);
  return text + quantities_text() + materials_text();
}

}  // namespace moraine
