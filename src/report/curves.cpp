#include "report/curves.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "report/settings.hpp"
#include "report/thinning.hpp"

namespace moraine::report {
namespace {

/// What a column of gauges.csv belongs to: names of gauges may hold blanks, names of quantities
/// not.
struct Owner {
  std::string gauge, quantity;
};

Owner owner_of(std::string const& label) {
  std::size_t const space = label.rfind(' ');
  if (space == std::string::npos) return {"", label};
  return {label.substr(0, space), label.substr(space + 1)};
}

std::map<std::string, std::string> kinds_of_gauges(RunFiles const& run) {
  std::map<std::string, std::string> kinds;
  if (!run.used_case) return kinds;
  for (GaugeSpec const& gauge : run.used_case->gauges) kinds[gauge.name] = kind_name(gauge);
  return kinds;
}

/// The points of a line are gauges of their own: "name[3]".
std::string kind_of(std::string const& gauge, std::map<std::string, std::string> const& kinds) {
  auto found = kinds.find(gauge);
  if (found == kinds.end() && gauge.ends_with(']'))
    found = kinds.find(gauge.substr(0, gauge.rfind('[')));
  return found == kinds.end() ? "" : found->second;
}

std::string group_of_sum(TableColumn const& column) {
  if (column.unit == "J") return "energy";
  if (column.unit == "kg m/s" || column.unit == "N s") return "momentum";
  if (column.unit == "s") return "step";
  return "mass";
}

std::vector<double> at_rows(std::vector<double> const& values,
                            std::vector<std::size_t> const& rows) {
  std::vector<double> chosen;
  chosen.reserve(rows.size());
  for (std::size_t const row : rows) chosen.push_back(values[row]);
  return chosen;
}

template <class Describe>
Json table_of(char const* name, Table const& table, std::size_t most_rows, Block& block,
              bool precise, Describe const& describe) {
  auto const rows = shown_rows(table, most_rows);
  auto columns = Json::array();
  for (std::size_t k = 1; k < table.columns.size(); ++k) {
    auto const values = at_rows(table.values[k], rows);
    Json column = describe(table.columns[k]);
    column["data"] = precise ? block.add_f64(values) : block.add_f32(values);
    columns.push_back(std::move(column));
  }
  return {{"name", name},
          {"rows", rows.size()},
          {"rows_of", table.rows()},
          {"time", block.add_f64(at_rows(table.values.front(), rows))},
          {"columns", std::move(columns)}};
}

bool has_something(Table const& table) { return table.rows() > 0 && table.columns.size() > 1; }

}  // namespace

Json tables_of(RunFiles const& run, std::size_t most_rows, Block& block) {
  auto tables = Json::array();
  if (has_something(run.gauges)) {
    auto const kinds = kinds_of_gauges(run);
    tables.push_back(
        table_of("gauges", run.gauges, most_rows, block, false, [&](TableColumn const& column) {
          Owner const owner = owner_of(column.name);
          return Json{{"label", column.name},
                      {"gauge", owner.gauge},
                      {"name", owner.quantity},
                      {"unit", column.unit},
                      {"group", kind_of(owner.gauge, kinds)}};
        }));
  }
  // A drift of a total is seen in the last digits of it.
  if (has_something(run.sums))
    tables.push_back(
        table_of("sums", run.sums, most_rows, block, true, [](TableColumn const& column) {
          return Json{{"label", column.name},
                      {"gauge", ""},
                      {"name", column.name},
                      {"unit", column.unit},
                      {"group", group_of_sum(column)}};
        }));
  return tables;
}

}  // namespace moraine::report
