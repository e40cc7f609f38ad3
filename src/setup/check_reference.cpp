#include "setup/check_reference.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/input_error.hpp"

namespace moraine {
namespace {

void check_gauge(Case const& c, ReferenceSpec const& reference, std::string const& key,
                 Source& source) {
  if (!source.good(key)) return;
  std::vector<std::string_view> names;
  for (GaugeSpec const& gauge : c.gauges) names.push_back(gauge.name);
  if (std::find(names.begin(), names.end(), reference.gauge) == names.end())
    source.report_value(key, "is not a gauge of this case", name_hint(reference.gauge, names));
}

void check_file(Case const& c, ReferenceSpec& reference, std::string const& key, Source& source) {
  std::filesystem::path path = reference.file;
  if (path.is_relative()) path = std::filesystem::path(c.file).parent_path() / path;
  std::error_code ignored;
  path = std::filesystem::absolute(path, ignored).lexically_normal();
  reference.file = path.string();
  if (!std::filesystem::is_regular_file(path, ignored))
    source.report_value(key, fmt::format("is no file: there is no {}", reference.file));
}

}  // namespace

void check_reference(Case const& c, ReferenceSpec& reference, std::string const& key,
                     Source& source) {
  check_gauge(c, reference, key + ".gauge", source);
  bool const filed = !reference.file.empty();
  if (filed && source.good(key + ".file")) check_file(c, reference, key + ".file", source);
  if (filed && reference.value && source.good(key + ".value"))
    source.report_value(key + ".value", "is given together with file", "leave out one of the two");
  if (filed && reference.tolerance && source.good(key + ".tolerance"))
    source.report_value(key + ".tolerance", "belongs to a value, not to a curve", "leave it out");
  if (filed && reference.within && source.good(key + ".within"))
    source.report_value(key + ".within", "belongs to a value, not to a curve", "leave it out");
  if (reference.tolerance && reference.within && source.good(key + ".within"))
    source.report_value(key + ".within", "is given together with tolerance",
                        "leave out one of the two");
  if (reference.tolerance && reference.value == 0.0 && source.good(key + ".tolerance"))
    source.report_value(key + ".tolerance", "is a share of a value that is zero",
                        "give within, in the unit of the value");
  if (!filed && !reference.value && !source.has_problem(key + ".value"))
    source.report_key(key, source.place_of(key), "has neither value nor file",
                      "give one of the two");
  bool const needs_arrival =
      reference.measure == ReadingMeasure::arrival || reference.measure == ReadingMeasure::duration;
  if (!filed && needs_arrival && !c.output.arrival_pressure &&
      !source.has_problem("output.arrival_pressure"))
    source.report_value(key + ".measure", "is not known: nothing says what an arrival is",
                        "give output.arrival_pressure");
}

}  // namespace moraine
