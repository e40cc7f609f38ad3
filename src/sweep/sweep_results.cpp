#include "sweep/sweep_results.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace moraine {
namespace {

using State = SweepTable::State;

std::optional<double> number_or_nothing(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

MemberCost cost_of(std::filesystem::path const& folder) {
  SweepOutput steps, wall_time;
  steps.from = wall_time.from = OutputSource::run;
  steps.number = RunNumber::steps;
  wall_time.number = RunNumber::wall_time;
  auto const values = read_outputs({steps, wall_time}, folder);
  return {number_or_nothing(values[0]), number_or_nothing(values[1])};
}

std::string cell(std::variant<double, std::string> const& value) {
  if (auto const* text = std::get_if<std::string>(&value)) return *text;
  return fmt::format("{:.5g}", std::get<double>(value));
}

std::string heading(SweepTable::Heading const& column) {
  return column.unit.empty() ? column.label : fmt::format("{} [{}]", column.label, column.unit);
}

/// Characters, of which UTF-8 may need several bytes.
std::size_t width_of(std::string const& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

using Rows = std::vector<std::vector<std::string>>;

std::string aligned(Rows const& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (auto const& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  std::string text;
  for (auto const& row : rows) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c)
      line += row[c] + std::string(widths[c] - width_of(row[c]) + 2, ' ');
    text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
  }
  return text;
}

}  // namespace

SweepResults::SweepResults(SweepPlan const& plan) : plan_(plan), costs_(plan.members.size()) {
  table_.title = plan.title;
  for (SweepColumn const& column : plan.columns())
    table_.parameters.push_back({column.label, column.unit});
  for (SweepOutput const& output : plan.outputs)
    table_.outputs.push_back({output.label, output.unit});
  for (SweepMember const& member : plan.members) {
    auto& row = table_.members.emplace_back();
    row.name = member.name;
    for (SweepValue const& value : member.values) row.values.push_back(value.shown);
    row.outputs.resize(plan.outputs.size());
  }
}

void SweepResults::take(std::size_t member, MemberFolder const& place, MemberStatus const& status) {
  auto& row = table_.members[member];
  row.state = status.state == MemberState::done     ? State::done
              : status.state == MemberState::failed ? State::failed
                                                    : State::waiting;
  row.message = row.state == State::failed ? status.message : "";
  if (row.state != State::done) return;
  try {
    auto const values = read_outputs(plan_.outputs, place.folder);
    std::transform(values.begin(), values.end(), row.outputs.begin(), number_or_nothing);
    costs_[member] = cost_of(place.folder);
  } catch (std::exception const& error) {
    row.state = State::failed;
    row.message = fmt::format("its results cannot be read: {}", error.what());
  }
}

std::size_t SweepResults::count(State state) const {
  return static_cast<std::size_t>(
      std::count_if(table_.members.begin(), table_.members.end(),
                    [state](SweepTable::Member const& member) { return member.state == state; }));
}

void SweepResults::write(std::filesystem::path const& folder) const {
  write_sweep_csv(table_, costs_, folder / "sweep.csv");
  write_sweep_json(table_, costs_, folder / "sweep.json");
}

std::string SweepResults::text() const {
  std::vector<std::size_t> shown;  // columns
  std::size_t column = 0;
  for (SweepAxis const& axis : plan_.axes)
    for (std::size_t i = 0; i < axis.columns.size(); ++i, ++column)
      if (axis.varies()) shown.push_back(column);
  Rows rows{{"member", "state"}};
  for (std::size_t const c : shown) rows[0].push_back(heading(table_.parameters[c]));
  for (auto const& output : table_.outputs) rows[0].push_back(heading(output));
  for (auto const& member : table_.members) {
    auto& row = rows.emplace_back();
    row = {member.name, state_name(member.state)};
    for (std::size_t const c : shown) row.push_back(cell(member.values[c]));
    for (auto const& output : member.outputs)
      row.push_back(output ? fmt::format("{:.5g}", *output) : "-");
  }
  return aligned(rows);
}

}  // namespace moraine
