#include "sweep/sweep_output.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "output/balances.hpp"
#include "output/table_csv.hpp"
#include "probes/reading_summary.hpp"

namespace moraine {
namespace {

using Json = nlohmann::json;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

Json json_of(std::filesystem::path const& file) {
  std::ifstream stream(file);
  Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object()) throw std::runtime_error(fmt::format("cannot read '{}'", file.string()));
  return json;
}

double number_in(Json const& json, char const* key) {
  auto const found = json.find(key);
  return found != json.end() && found->is_number() ? found->get<double>() : nothing;
}

/// The name of a measure in gauges.json.
char const* name_in_summary(Measure measure) {
  switch (measure) {
    case Measure::largest:
      return "largest";
    case Measure::time_of_largest:
      return "time_of_largest";
    case Measure::smallest:
      return "smallest";
    case Measure::time_of_smallest:
      return "time_of_smallest";
    case Measure::integral:
      return "integral_over_time";
    case Measure::impulse:
      return "impulse";
    case Measure::arrival:
      return "arrival";
    case Measure::duration:
      return "duration";
    case Measure::decay_exponent:
    case Measure::last:
      break;
  }
  return "";
}

double last_of(std::vector<double> const& values) {
  auto const found = std::find_if(values.rbegin(), values.rend(),
                                  [](double value) { return std::isfinite(value); });
  return found != values.rend() ? *found : nothing;
}

double measure_of(std::vector<double> const& times, std::vector<double> const& values,
                  Measure measure) {
  if (measure == Measure::last) return last_of(values);
  ReadingSummary summary;
  for (std::size_t i = 0; i < values.size(); ++i) summary.add(times[i], values[i]);
  switch (measure) {
    case Measure::largest:
      return summary.largest();
    case Measure::time_of_largest:
      return summary.time_of_largest();
    case Measure::smallest:
      return summary.smallest();
    case Measure::time_of_smallest:
      return summary.time_of_smallest();
    case Measure::integral:
      return summary.integral();
    default:
      return nothing;
  }
}

/// The files of a run, each read once.
class RunFiles {
 public:
  explicit RunFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  double value(SweepOutput const& output) {
    switch (output.from) {
      case OutputSource::gauge:
        return of_gauge(output);
      case OutputSource::sums:
        return measure_of(column(sums(), "time"), column(sums(), output.column), output.measure);
      case OutputSource::run:
        return of_run(output.number);
    }
    return nothing;
  }

 private:
  double of_gauge(SweepOutput const& output) {
    if (output.measure == Measure::last) {
      if (!gauges_) gauges_ = read_table_csv(folder_ / "gauges.csv");
      return last_of(column(*gauges_, output.column));
    }
    if (summary_.is_null()) summary_ = json_of(folder_ / "gauges.json");
    for (Json const& gauge : summary_.at("gauges")) {
      if (gauge.at("name") != output.gauge) continue;
      if (output.measure == Measure::decay_exponent)
        return gauge.contains("decay") ? number_in(gauge.at("decay"), "exponent") : nothing;
      Json const& columns = gauge.at("columns");
      if (columns.contains(output.column))
        return number_in(columns.at(output.column), name_in_summary(output.measure));
    }
    return nothing;
  }

  double of_run(RunNumber number) {
    if (number == RunNumber::energy_error) return energy_error();
    if (manifest_.is_null()) manifest_ = json_of(folder_ / "manifest.json");
    if (!manifest_.contains("end")) return nothing;
    Json const& end = manifest_.at("end");
    switch (number) {
      case RunNumber::wall_time:
        return number_in(end, "wall_time_s");
      case RunNumber::steps:
        return number_in(end, "steps");
      case RunNumber::simulated_time:
        return number_in(end, "simulated_time_s");
      case RunNumber::particles:
        return number_in(end, "particles");
      case RunNumber::energy_error:
        break;
    }
    return nothing;
  }

  double energy_error() {
    auto const drift = energy_drift(sums());
    return drift ? drift->share() : nothing;
  }

  Table const& sums() {
    if (!sums_) sums_ = read_table_csv(folder_ / "sums.csv");
    return *sums_;
  }

  std::vector<double> const& column(Table const& table, std::string const& name) const {
    auto const* values = table.find(name);
    if (values == nullptr || values->empty())
      throw std::runtime_error(fmt::format("'{}' has no readings of {}", folder_.string(), name));
    return *values;
  }

  std::filesystem::path folder_;
  Json summary_, manifest_;
  std::optional<Table> gauges_, sums_;
};

}  // namespace

std::string unit_of(Measure measure, std::string const& column_unit) {
  switch (measure) {
    case Measure::time_of_largest:
    case Measure::time_of_smallest:
    case Measure::arrival:
    case Measure::duration:
      return "s";
    case Measure::decay_exponent:
      return "";
    case Measure::integral:
    case Measure::impulse:
      return column_unit.empty() ? "s" : column_unit + " s";
    default:
      return column_unit;
  }
}

std::string unit_of(RunNumber number) {
  return number == RunNumber::wall_time || number == RunNumber::simulated_time ? "s" : "";
}

std::vector<double> read_outputs(std::vector<SweepOutput> const& outputs,
                                 std::filesystem::path const& folder) {
  RunFiles files(folder);
  std::vector<double> values;
  for (SweepOutput const& output : outputs) values.push_back(files.value(output));
  return values;
}

}  // namespace moraine
