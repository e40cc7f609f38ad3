#include "sweep/make_members.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

namespace moraine {
namespace {

constexpr std::size_t longest_name = 40;  // of the values in it

using Row = std::vector<SweepValue>;

/// Which value of each axis, one list for each member.
std::vector<std::vector<std::size_t>> grid_indices(std::vector<SweepAxis> const& axes) {
  std::vector<std::vector<std::size_t>> all{{}};
  for (SweepAxis const& axis : axes) {
    std::vector<std::vector<std::size_t>> longer;
    for (auto const& head : all)
      for (std::size_t i = 0; i < axis.values.size(); ++i) {
        longer.push_back(head);
        longer.back().push_back(i);
      }
    all = std::move(longer);
  }
  return all;
}

void append(Row& row, Row const& more) { row.insert(row.end(), more.begin(), more.end()); }

std::vector<Row> grid_rows(SweepPlan const& plan) {
  std::vector<Row> rows;
  for (auto const& indices : grid_indices(plan.axes)) {
    Row& row = rows.emplace_back();
    for (std::size_t a = 0; a < indices.size(); ++a) append(row, plan.axes[a].values[indices[a]]);
  }
  return rows;
}

std::vector<Row> list_rows(SweepPlan const& plan) {
  std::vector<Row> rows(count_members(plan));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (SweepAxis const& axis : plan.axes) append(rows[i], axis.values[axis.varies() ? i : 0]);
  return rows;
}

/// Axes without a range are drawn too: their values have equal shares of the stratified interval.
std::vector<Row> drawn_rows(SweepPlan const& plan) {
  std::vector<Row> rows(count_members(plan));
  auto const points =
      latin_hypercube(plan.axes.size(), rows.size(), static_cast<std::uint64_t>(plan.seed));
  for (std::size_t a = 0; a < plan.axes.size(); ++a) {
    SweepAxis const& axis = plan.axes[a];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double const place = points[a][i];
      append(rows[i], axis.range ? values_of(axis, axis.range->at(place))
                                 : axis.values[value_at(place, axis.values.size())]);
    }
  }
  return rows;
}

/// Short, and a name of a file; members are told apart by their numbers.
std::string slug(SweepValue const& value) {
  auto const* number = std::get_if<double>(&value.shown);
  bool const bare = number != nullptr && !value.toml.starts_with('"');
  std::string text;
  for (char const c : bare ? fmt::format("{:.4g}", *number) : value.toml) {
    bool const plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-';
    if (plain)
      text += c;
    else if (!text.empty() && text.back() != '_')
      text += '_';
  }
  while (!text.empty() && text.back() == '_') text.pop_back();
  return text;
}

std::string name_of(SweepPlan const& plan, std::size_t number, std::size_t digits, Row const& row) {
  std::string values;
  std::size_t column = 0;
  for (SweepAxis const& axis : plan.axes) {
    if (axis.varies()) values += "-" + slug(row[column]);
    column += axis.columns.size();
  }
  return fmt::format("{:0{}}{}", number, digits, values.substr(0, longest_name));
}

}  // namespace

std::vector<SweepColumn> SweepPlan::columns() const {
  std::vector<SweepColumn> all;
  for (SweepAxis const& axis : axes)
    all.insert(all.end(), axis.columns.begin(), axis.columns.end());
  return all;
}

std::size_t count_members(SweepPlan const& plan) {
  if (plan.method == SweepMethod::latin_hypercube)
    return static_cast<std::size_t>(plan.samples.value_or(0));
  std::size_t count = 1;
  for (SweepAxis const& axis : plan.axes)
    count = plan.method == SweepMethod::list
                ? std::max(count, axis.values.size())
                : std::min(count * axis.values.size(), most_members + 1);
  return count;
}

std::vector<SweepMember> make_members(SweepPlan const& plan) {
  auto rows = plan.method == SweepMethod::grid   ? grid_rows(plan)
              : plan.method == SweepMethod::list ? list_rows(plan)
                                                 : drawn_rows(plan);
  std::size_t const digits = std::max<std::size_t>(3, fmt::format("{}", rows.size()).size());
  std::vector<SweepMember> members;
  for (Row& row : rows) {
    std::string name = name_of(plan, members.size() + 1, digits, row);
    members.push_back({std::move(name), std::move(row)});
  }
  return members;
}

}  // namespace moraine
