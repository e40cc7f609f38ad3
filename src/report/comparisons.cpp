#include "report/comparisons.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "output/references.hpp"
#include "report/quality.hpp"

namespace moraine::report {
namespace {

char const* summary_key(ReadingMeasure measure) {
  switch (measure) {
    case ReadingMeasure::smallest:
      return "smallest";
    case ReadingMeasure::time_of_largest:
      return "time_of_largest";
    case ReadingMeasure::time_of_smallest:
      return "time_of_smallest";
    case ReadingMeasure::arrival:
      return "arrival";
    case ReadingMeasure::duration:
      return "duration";
    case ReadingMeasure::impulse:
      return "impulse";
    case ReadingMeasure::integral:
      return "integral_over_time";
    default:
      return "largest";
  }
}

std::string unit_of(ReadingMeasure measure, std::string const& unit) {
  switch (measure) {
    case ReadingMeasure::time_of_largest:
    case ReadingMeasure::time_of_smallest:
    case ReadingMeasure::arrival:
    case ReadingMeasure::duration:
      return "s";
    case ReadingMeasure::impulse:
    case ReadingMeasure::integral:
      return unit.empty() ? "s" : unit + " s";
    default:
      return unit;
  }
}

std::optional<double> value_of(RunFiles const& run, ReferenceSpec const& reference,
                               std::string const& column) {
  if (reference.measure == ReadingMeasure::last) {
    auto const* const values = run.gauges.find(column);
    if (values == nullptr) return {};
    auto const last = std::find_if(values->rbegin(), values->rend(),
                                   [](double value) { return std::isfinite(value); });
    if (last == values->rend()) return {};
    return *last;
  }
  if (!run.gauge_summary.contains("gauges") || !run.gauge_summary["gauges"].is_array()) return {};
  for (auto const& gauge : run.gauge_summary["gauges"]) {
    if (text_at(gauge, "name") != reference.gauge || !gauge.contains("columns")) continue;
    auto const& columns = gauge["columns"];
    if (columns.is_object() && columns.contains(column))
      return number_at(columns[column], summary_key(reference.measure));
  }
  return {};
}

/// The largest difference that passes; nothing where the case does not judge.
std::optional<double> allowed_by(ReferenceSpec const& reference) {
  if (reference.within) return reference.within;
  if (reference.tolerance) return *reference.tolerance * std::abs(*reference.value);
  return {};
}

Verdict judged(std::optional<double> value, ReferenceSpec const& reference) {
  auto const allowed = allowed_by(reference);
  if (!value || !allowed) return Verdict::unknown;
  return std::abs(*value - *reference.value) <= *allowed ? Verdict::good : Verdict::bad;
}

}  // namespace

Json comparisons_of(RunFiles const& run) {
  auto list = Json::array();
  if (!run.used_case) return list;
  for (ReferenceSpec const& reference : run.used_case->references) {
    if (!reference.value) continue;
    TableColumn const column = column_of(*run.used_case, reference);
    auto const value = value_of(run, reference, column.name);
    Json row{{"name", reference.name},
             {"unit", unit_of(reference.measure, column.unit)},
             {"value", value ? Json(*value) : Json(nullptr)},
             {"reference", *reference.value},
             {"tolerance", nullptr},
             {"verdict", verdict_name(judged(value, reference))},
             {"source", reference.source}};
    if (auto const allowed = allowed_by(reference)) row["tolerance"] = *allowed;
    list.push_back(std::move(row));
  }
  return list;
}

Json references_of(RunFiles& run, Block& block) {
  auto list = Json::array();
  if (!run.used_case) return list;
  for (ReferenceSpec const& reference : run.used_case->references) {
    if (reference.file.empty()) continue;
    try {
      ReferenceCurve const curve = read_reference_curve(reference.file);
      list.push_back({{"name", reference.name},
                      {"table", "gauges"},
                      {"column", column_of(*run.used_case, reference).name},
                      {"source", reference.source},
                      {"time", block.add_f64(curve.time)},
                      {"value", block.add_f64(curve.value)}});
    } catch (std::exception const& error) {
      run.notes.push_back(
          fmt::format("the curve {} is left out: {}", reference.name, error.what()));
    }
  }
  return list;
}

}  // namespace moraine::report
