#include "report/curves.hpp"

#include <fmt/core.h>

#include <functional>
#include <map>
#include <set>
#include <string>

#include "output/references.hpp"
#include "report/page.hpp"
#include "report/settings.hpp"
#include "report/thinning.hpp"

namespace moraine::report {
namespace {

constexpr double base64 = 4.0 / 3.0;

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

struct Source {
  char const* name;
  Table const& table;
  bool precise;  // 64 bits
  std::function<Json(TableColumn const&)> describe;
  std::set<std::string> wanted{};  // columns that are left out last
};

TableCost cost_of(Source const& source) {
  std::size_t described = 0;
  for (TableColumn const& column : source.table.columns)
    described += bytes_in_page(source.describe(column));
  constexpr double numbers = 90.0;  // "data":{"block":"run-12/curves","offset":12345678, ...
  return {
      (source.precise ? 8.0 : 4.0) * base64,
      numbers + static_cast<double>(described) / static_cast<double>(source.table.columns.size())};
}

/// Adds a table as far as it fits.
void add_table(Source const& source, std::size_t bytes, Curves& curves, Block& block) {
  Table const& table = source.table;
  TablePart const whole{table.columns.size() - 1, table.rows()};
  TablePart const part = part_that_fits(whole, cost_of(source), bytes);
  if (part.columns < whole.columns)
    curves.notes.push_back(fmt::format("{} of the {} columns of {}.csv are left out of this page",
                                       whole.columns - part.columns, whole.columns, source.name));
  curves.whole = curves.whole && part.columns == whole.columns && part.rows == whole.rows;
  if (part.columns == 0) return;
  auto const chosen = shown_columns(table, part.columns, source.wanted);
  auto const rows = shown_rows(table, chosen, part.rows);
  auto columns = Json::array();
  for (std::size_t const k : chosen) {
    auto const values = at_rows(table.values[k], rows);
    Json column = source.describe(table.columns[k]);
    column["data"] = source.precise ? block.add_f64(values) : block.add_f32(values);
    columns.push_back(std::move(column));
  }
  curves.tables.push_back({{"name", source.name},
                           {"rows", rows.size()},
                           {"rows_of", table.rows()},
                           {"time", block.add_f64(at_rows(table.values.front(), rows))},
                           {"columns", std::move(columns)}});
}

bool has_something(Table const& table) { return table.rows() > 0 && table.columns.size() > 1; }

Source gauges_of(RunFiles const& run) {
  Source source{"gauges", run.gauges, false,
                [kinds = kinds_of_gauges(run)](TableColumn const& column) {
                  std::string const gauge = gauge_of(column.name);
                  std::size_t const name = gauge.empty() ? 0 : gauge.size() + 1;
                  return Json{{"label", column.name},
                              {"gauge", gauge},
                              {"name", column.name.substr(name)},
                              {"unit", column.unit},
                              {"group", kind_of(gauge, kinds)}};
                }};
  if (run.used_case)
    for (ReferenceSpec const& reference : run.used_case->references)
      source.wanted.insert(column_of(*run.used_case, reference).name);
  return source;
}

// A drift of a total is seen in the last digits of it.
Source sums_of(RunFiles const& run) {
  return {"sums", run.sums, true, [](TableColumn const& column) {
            return Json{{"label", column.name},
                        {"gauge", ""},
                        {"name", column.name},
                        {"unit", column.unit},
                        {"group", group_of_sum(column)}};
          }};
}

/// Tables that take `bytes` at most before compression.
Curves uncompressed_to(RunFiles const& run, std::size_t bytes) {
  Curves curves;
  Block block(run.prefix + "/curves");
  bool const sums = has_something(run.sums), gauges = has_something(run.gauges);
  if (gauges) add_table(gauges_of(run), sums ? bytes / 3 * 2 : bytes, curves, block);
  if (sums) add_table(sums_of(run), gauges ? bytes / 3 : bytes, curves, block);
  if (!curves.tables.empty()) curves.blocks.add(block);
  return curves;
}

}  // namespace

std::size_t Curves::bytes() const { return bytes_in_page(tables) + blocks.size(); }

Curves curves_of(RunFiles const& run, std::size_t bytes) {
  Curves best;
  best.whole = !has_something(run.gauges) && !has_something(run.sums);
  if (!best.whole) best.notes.push_back("curves are left out of this page");
  auto const room = static_cast<double>(bytes);
  double offer = room;  // more where numbers shrink, which nobody knows beforehand
  for (int tries = 0; tries < 4 && !best.whole; ++tries) {
    Curves now = uncompressed_to(run, static_cast<std::size_t>(offer));
    if (now.tables.empty()) break;
    auto const used = static_cast<double>(now.bytes());
    bool const full = used > 0.8 * room;
    if (used <= room) best = std::move(now);
    if (used <= room && full) break;
    offer *= 0.95 * room / used;
  }
  return best;
}

}  // namespace moraine::report
