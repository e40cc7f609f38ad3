#include "records/record_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "base/gravity.hpp"
#include "base/units.hpp"
#include "records/record_formats.hpp"

namespace moraine {
namespace {

constexpr std::uintmax_t most_bytes = 100'000'000;

[[noreturn]] void refuse(std::string const& file, std::string rule, std::string hint = {}) {
  throw InputErrors({{file, 0, 0, "", "", std::move(rule), std::move(hint)}});
}

double largest_size(std::vector<double> const& values) {
  double largest = 0.0;
  for (double const value : values) largest = std::max(largest, std::fabs(value));
  return largest;
}

/// What one of the numbers is [m/s^2].
double unit_of(FiledRecord const& filed, RecordHints const& hints, RecordMistakes& mistakes) {
  auto const told = acceleration_unit(hints.unit);
  if (!hints.unit.empty() && !told) {
    mistakes.add(0, fmt::format("unit \"{}\"", hints.unit), "is no unit of acceleration",
                 "choose g, m/s2 or cm/s2");
    return 1.0;
  }
  if (filed.another_quantity) return 1.0;  // told already
  if (filed.unit.empty() && !told) {
    mistakes.add(
        0, "",
        fmt::format("does not say the unit of its acceleration (the largest value is {:.4g})",
                    largest_size(filed.values)),
        "add --unit g, --unit m/s2 or --unit cm/s2");
    return 1.0;
  }
  if (filed.unit.empty()) return *told;
  auto const stated = acceleration_unit(filed.unit);
  if (!stated)
    mistakes.add(0, fmt::format("unit \"{}\"", filed.unit), "is no unit of acceleration");
  else if (told && std::fabs(*told / *stated - 1.0) > 1e-6)
    mistakes.add(0, fmt::format("unit \"{}\"", hints.unit),
                 fmt::format("is not what the file says, \"{}\"", filed.unit), "leave out --unit");
  return stated.value_or(1.0);
}

double step_of(FiledRecord const& filed, RecordHints const& hints, RecordMistakes& mistakes) {
  if (filed.time_step > 0.0) {
    if (hints.time_step && std::fabs(*hints.time_step / filed.time_step - 1.0) > 1e-3)
      mistakes.add(0, fmt::format("time step {:.6g} s", *hints.time_step),
                   fmt::format("is not what the file says, {:.6g} s", filed.time_step),
                   "leave out --time-step");
    return filed.time_step;
  }
  if (!hints.time_step && mistakes.empty())
    mistakes.add(0, "", "does not say its time step", "add --time-step \"0.01 s\"");
  else if (hints.time_step && !(*hints.time_step > 0.0))
    mistakes.add(0, fmt::format("time step {:.6g} s", *hints.time_step), "is not positive");
  return hints.time_step.value_or(1.0);
}

}  // namespace

std::optional<double> acceleration_unit(std::string_view unit) {
  if (unit.empty()) return std::nullopt;
  if (unit == "g" || unit == "G" || unit == "g0") return standard_gravity;
  if (unit == "gal" || unit == "Gal" || unit == "GAL") return 0.01;
  std::string text(unit);
  for (auto power = text.find("**"); power != std::string::npos; power = text.find("**"))
    text.replace(power, 2, "^");
  auto value = to_si("1 " + text, Quantity::acceleration).value;
  if (!value) {  // headers shout: "CM/SEC/SEC"
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    value = to_si("1 " + text, Quantity::acceleration).value;
  }
  return value && *value > 0.0 ? value : std::nullopt;
}

GroundRecord parse_record(std::string_view text, std::string const& name,
                          RecordHints const& hints) {
  if (!is_text(text)) refuse(name, "is not a text", "save it as plain text (UTF-8)");
  RecordMistakes mistakes(name);
  auto const lines = lines_of(text);
  auto const header_end = at2_header_end(lines);
  FiledRecord const filed = header_end ? read_at2(lines, *header_end, mistakes)
                                       : read_columns(lines, hints.time_step.has_value(), mistakes);
  if (filed.values.size() < 2 && mistakes.empty()) {
    mistakes.add(0, "",
                 fmt::format("holds {} values; a record has two or more", filed.values.size()));
    mistakes.raise();
  }
  double const step = step_of(filed, hints, mistakes);
  double const unit = unit_of(filed, hints, mistakes);
  mistakes.raise();
  GroundRecord record{std::filesystem::path(name).stem().string(), step, filed.start, filed.values};
  for (double& value : record.acceleration) value *= unit;
  try {
    check_record(record);  // large numbers leave the range of doubles in SI units
  } catch (std::invalid_argument const& error) {
    refuse(name, error.what());
  }
  return record;
}

GroundRecord read_record(std::filesystem::path const& path, RecordHints const& hints) {
  std::error_code error;
  std::string const name = path.string();
  if (!std::filesystem::exists(path, error)) refuse(name, "does not exist");
  if (!std::filesystem::is_regular_file(path, error)) refuse(name, "is not a file");
  if (std::filesystem::file_size(path, error) > most_bytes)
    refuse(name, fmt::format("is larger than {} bytes", most_bytes));
  std::ifstream file(path, std::ios::binary);
  std::string const text{std::istreambuf_iterator<char>(file), {}};
  if (!file) refuse(name, "cannot be read");
  return parse_record(text, name, hints);
}

}  // namespace moraine
