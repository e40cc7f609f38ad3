#include "sweep/sweep_table.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/atomic_file.hpp"
#include "output/table_csv.hpp"

namespace moraine {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<char const*, 3> state_names{"done", "failed", "waiting"};

std::string heading(SweepTable::Heading const& column) {
  return csv_field(column.unit.empty() ? column.label
                                       : fmt::format("{} [{}]", column.label, column.unit));
}

std::string number(std::optional<double> const& value) {
  return value ? fmt::format("{}", *value) : std::string();
}

std::string value_field(std::variant<double, std::string> const& value) {
  if (auto const* text = std::get_if<std::string>(&value)) return csv_field(*text);
  return fmt::format("{}", std::get<double>(value));
}

std::string line_of(SweepTable::Member const& member, MemberCost const& cost) {
  std::string line = fmt::format("{},{}", csv_field(member.name), state_name(member.state));
  for (auto const& value : member.values) line += ',' + value_field(value);
  for (auto const& output : member.outputs) line += ',' + number(output);
  return line + fmt::format(",{},{},{}\n", number(cost.steps), number(cost.wall_time),
                            csv_field(member.message));
}

Json headings_json(std::vector<SweepTable::Heading> const& headings) {
  Json list = Json::array();
  for (auto const& heading : headings)
    list.push_back(Json{{"label", heading.label}, {"unit", heading.unit}});
  return list;
}

Json number_json(std::optional<double> const& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json member_json(SweepTable::Member const& member, MemberCost const& cost) {
  Json values = Json::array();
  for (auto const& value : member.values) {
    auto const* number = std::get_if<double>(&value);
    if (number != nullptr && std::isfinite(*number))
      values.push_back(*number);
    else  // JSON has no infinity
      values.push_back(number != nullptr ? fmt::format("{}", *number)
                                         : std::get<std::string>(value));
  }
  Json outputs = Json::array();
  for (auto const& output : member.outputs) outputs.push_back(number_json(output));
  return {{"name", member.name},
          {"state", state_name(member.state)},
          {"message", member.message},
          {"run", member.run ? Json(*member.run) : Json(nullptr)},
          {"values", values},
          {"outputs", outputs},
          {"steps", number_json(cost.steps)},
          {"wall_time_s", number_json(cost.wall_time)}};
}

std::vector<SweepTable::Heading> headings_of(Json const& list) {
  std::vector<SweepTable::Heading> headings;
  for (Json const& item : list)
    headings.push_back({item.at("label").get<std::string>(), item.at("unit").get<std::string>()});
  return headings;
}

SweepTable::State state_of(std::string const& name) {
  for (std::size_t i = 0; i < state_names.size(); ++i)
    if (name == state_names[i]) return static_cast<SweepTable::State>(i);
  throw std::runtime_error(fmt::format("\"{}\" is no state of a member", name));
}

SweepTable::Member member_of(Json const& json) {
  SweepTable::Member member{json.at("name").get<std::string>(),
                            state_of(json.at("state").get<std::string>()),
                            json.at("message").get<std::string>(),
                            std::nullopt,
                            {},
                            {}};
  for (Json const& value : json.at("values")) {
    if (value.is_string())
      member.values.emplace_back(value.get<std::string>());
    else
      member.values.emplace_back(value.get<double>());
  }
  for (Json const& output : json.at("outputs"))
    member.outputs.push_back(output.is_null() ? std::nullopt : std::optional(output.get<double>()));
  return member;
}

}  // namespace

char const* state_name(SweepTable::State state) {
  return state_names[static_cast<std::size_t>(state)];
}

void write_sweep_csv(SweepTable const& table, std::vector<MemberCost> const& costs,
                     std::filesystem::path const& file) {
  AtomicFile csv(file);
  csv.stream() << "member,state";
  for (auto const& parameter : table.parameters) csv.stream() << ',' << heading(parameter);
  for (auto const& output : table.outputs) csv.stream() << ',' << heading(output);
  csv.stream() << ",steps,wall_time [s],message\n";
  for (std::size_t i = 0; i < table.members.size(); ++i)
    csv.stream() << line_of(table.members[i], costs.at(i));
  csv.commit();
}

nlohmann::ordered_json sweep_json(SweepTable const& table, std::vector<MemberCost> const& costs) {
  Json members = Json::array();
  for (std::size_t i = 0; i < table.members.size(); ++i)
    members.push_back(member_json(table.members[i], costs.empty() ? MemberCost{} : costs.at(i)));
  return {{"title", table.title},
          {"parameters", headings_json(table.parameters)},
          {"outputs", headings_json(table.outputs)},
          {"members", members}};
}

void write_sweep_json(SweepTable const& table, std::vector<MemberCost> const& costs,
                      std::filesystem::path const& file) {
  AtomicFile out(file);
  out.stream() << sweep_json(table, costs).dump(2, ' ', false, Json::error_handler_t::replace)
               << '\n';
  out.commit();
}

SweepTable read_sweep_table(std::filesystem::path const& folder) {
  auto const file = folder / "sweep.json";
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("cannot read '{}'", file.string()));
  try {
    Json const json = Json::parse(stream);
    SweepTable table{json.at("title").get<std::string>(),
                     headings_of(json.at("parameters")),
                     headings_of(json.at("outputs")),
                     {}};
    for (Json const& member : json.at("members")) table.members.push_back(member_of(member));
    return table;
  } catch (nlohmann::json::exception const& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<std::filesystem::path> member_folders(SweepTable const& table,
                                                  std::filesystem::path const& folder) {
  std::vector<std::filesystem::path> folders;
  for (auto const& member : table.members) folders.push_back(folder / "members" / member.name);
  return folders;
}

}  // namespace moraine
