#include "output/blast/gauge_readings.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/input_error.hpp"

namespace moraine::blast {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(std::filesystem::path const& file, std::string const& value,
                         std::string rule, std::string hint) {
  throw InputErrors({{file.string(), 0, 0, "", value.empty() ? std::string() : "\"" + value + "\"",
                      std::move(rule), std::move(hint)}});
}

Json gauges_of(std::filesystem::path const& file) {
  std::ifstream stream(file);
  if (!stream) refuse(file, "", "cannot be read", "name the gauges.json of a run");
  Json const json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("gauges") || !json["gauges"].is_array())
    refuse(file, "", "holds no gauges", "name the gauges.json of a run");
  return json["gauges"];
}

/// The first column of pressures with readings, or null.
Json pressure_of(Json const& gauge) {
  for (auto const& [name, column] : gauge.at("columns").items())
    if (column.value("unit", "") == "Pa" && column.at("largest").is_number()) return column;
  return nullptr;
}

}  // namespace

std::optional<double> GaugeReadings::of(Measure measure) const {
  auto const found = std::ranges::find(readings, measure, &Reading::measure);
  return found == readings.end() ? std::nullopt : std::optional(found->value);
}

GaugeReadings read_gauge(std::filesystem::path const& file, std::string const& gauge) try {
  Json const gauges = gauges_of(file);
  auto const found = std::ranges::find_if(
      gauges, [&](Json const& candidate) { return candidate.value("name", "") == gauge; });
  if (found == gauges.end()) {
    std::vector<std::string> names;
    for (Json const& candidate : gauges) names.push_back(candidate.value("name", ""));
    std::vector<std::string_view> const known(names.begin(), names.end());
    refuse(file, gauge, "is not a gauge of this run", name_hint(gauge, known));
  }
  Json const column = pressure_of(*found);
  if (column.is_null()) refuse(file, gauge, "has seen no pressure", "");
  GaugeReadings result{gauge, {}};
  double const rise = column.at("largest").get<double>() - column.at("first").get<double>();
  result.readings = {{Measure::peak_overpressure, rise}, {Measure::peak_pressure, rise}};
  if (Json const impulse = column.value("impulse", Json()); impulse.is_number())
    result.readings.push_back({Measure::impulse, impulse.get<double>()});
  if (Json const arrival = column.value("arrival", Json()); arrival.is_number())
    result.readings.push_back({Measure::arrival_time, arrival.get<double>()});
  if (Json const duration = column.value("duration", Json()); duration.is_number())
    result.readings.push_back({Measure::positive_duration, duration.get<double>()});
  return result;
} catch (Json::exception const&) {
  refuse(file, "", "is no summary of gauges", "name the gauges.json of a run");
}

Estimate const* yardstick(Answer const& answer, Measure measure) {
  auto const found = std::ranges::find_if(answer.estimates, [&](Estimate const& estimate) {
    return estimate.relation->measure == measure && estimate.in_range &&
           estimate.standing == Standing::recommended;
  });
  return found == answer.estimates.end() ? nullptr : &*found;
}

}  // namespace moraine::blast
