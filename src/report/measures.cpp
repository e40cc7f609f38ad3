#include "report/measures.hpp"

#include <array>
#include <string>

#include "report/run_files.hpp"

namespace moraine::report {
namespace {

constexpr std::array measures{"first",    "largest",          "time_of_largest",
                              "smallest", "time_of_smallest", "integral_over_time",
                              "impulse",  "arrival",          "duration"};

Json number_or_null(nlohmann::json const& object, char const* key) {
  auto const number = number_at(object, key);
  return number ? Json(*number) : Json(nullptr);
}

/// Calls `tell(gauge, name)` for all gauges with a name.
template <class Tell>
void for_gauges(nlohmann::json const& summary, Tell const& tell) {
  if (!summary.is_object() || !summary.contains("gauges")) return;
  for (auto const& gauge : summary["gauges"])
    if (std::string const name = text_at(gauge, "name"); !name.empty()) tell(gauge, name);
}

bool has_seen(nlohmann::json const& gauge) {
  auto const seen = gauge.find("seen");
  return seen == gauge.end() || !seen->is_boolean() || seen->get<bool>();
}

/// "P1 pressure" of the gauge "P1" is its pressure; a point of a line keeps its number.
std::string without_gauge(std::string const& label, std::string const& gauge) {
  bool const begins = label.starts_with(gauge + ' ');
  return begins ? label.substr(gauge.size() + 1) : label;
}

}  // namespace

Json measures_of(nlohmann::json const& gauge_summary) {
  auto list = Json::array();
  for_gauges(gauge_summary, [&](nlohmann::json const& gauge, std::string const& name) {
    auto const columns = gauge.find("columns");
    if (columns == gauge.end() || !columns->is_object()) return;
    for (auto const& [label, column] : columns->items()) {
      if (!column.is_object()) continue;
      Json row{{"gauge", name},
               {"column", without_gauge(label, name)},
               {"unit", text_at(column, "unit")},
               {"seen", has_seen(gauge)}};
      for (char const* const measure : measures) row[measure] = number_or_null(column, measure);
      list.push_back(std::move(row));
    }
  });
  return list;
}

Json decays_of(nlohmann::json const& gauge_summary) {
  auto list = Json::array();
  for_gauges(gauge_summary, [&](nlohmann::json const& gauge, std::string const& name) {
    auto const decay = gauge.find("decay");
    if (decay == gauge.end() || !decay->is_object()) return;
    Json row{{"gauge", name}};
    for (char const* const key : {"exponent", "points", "scatter"})
      row[key] = number_or_null(*decay, key);
    list.push_back(std::move(row));
  });
  return list;
}

}  // namespace moraine::report
