// moraine exact: exact solutions as numbers, tables and pictures.
#include "app/exact_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/commands.hpp"
#include "app/exact_solution.hpp"
#include "base/input_error.hpp"
#include "output/atomic_file.hpp"
#include "output/plot/stacked_panels.hpp"

namespace moraine {
namespace {

[[noreturn]] void refuse(std::string key, std::string value, std::string rule, std::string hint) {
  throw InputErrors({{"moraine exact", 0, 0, std::move(key), std::move(value), std::move(rule),
                      std::move(hint)}});
}

void draw(ExactSolution const& solution, Table const& table, std::string const& path) {
  std::vector<plot::CurvePanel> panels;
  for (std::size_t k = 1; k < table.columns.size(); ++k)
    panels.push_back({table.columns[k].name, table.columns[k].unit, {{"", table.values[k]}}});
  plot::draw_stacked_panels(path, solution.name, {table.columns[0].name, table.values[0]},
                            table.columns[0].unit, panels);
}

/// "left = tnt", in the order of the parameters, without those that have no value.
std::string used_values(ExactSolution const& solution, ExactValues const& values) {
  std::string text;
  for (ExactParameter const& parameter : solution.parameters) {
    std::string value;
    if (parameter.kind != ExactValueKind::number)
      value = values.text(parameter.key);
    else if (values.has(parameter.key))
      value = parameter.dimension.unit == "1"
                  ? fmt::format("{}", values.number(parameter.key))
                  : fmt::format("{} {}", values.number(parameter.key), parameter.dimension.unit);
    if (!value.empty()) text += fmt::format("  {:<40}{}\n", parameter.key, value);
  }
  return text;
}

std::string answer_text(ExactSolution const& solution, ExactValues const& values,
                        ExactAnswer const& answer) {
  std::string text = fmt::format("{}: {}\nsource: {}\n\nparameters\n{}\nsolution\n", solution.name,
                                 solution.meaning, solution.source, used_values(solution, values));
  for (ExactNumber const& number : answer.numbers)
    text += fmt::format("  {:<40}{:.9g}{}{}\n", number.name, number.value,
                        number.unit.empty() ? "" : " ", number.unit);
  return text;
}

nlohmann::ordered_json answer_json(ExactSolution const& solution, ExactValues const& values,
                                   ExactAnswer const& answer) {
  nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
  for (ExactParameter const& parameter : solution.parameters)
    if (parameter.kind != ExactValueKind::number)
      parameters[std::string(parameter.key)] = values.text(parameter.key);
    else if (values.has(parameter.key))
      parameters[std::string(parameter.key)] = values.number(parameter.key);
  nlohmann::ordered_json numbers = nlohmann::ordered_json::array();
  for (ExactNumber const& number : answer.numbers)
    numbers.push_back({{"name", number.name}, {"value", number.value}, {"unit", number.unit}});
  nlohmann::ordered_json profile = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < answer.profile.columns.size(); ++k)
    profile.push_back({{"name", answer.profile.columns[k].name},
                       {"unit", answer.profile.columns[k].unit},
                       {"values", answer.profile.values[k]}});
  return {{"name", solution.name},
          {"source", solution.source},
          {"parameters", parameters},
          {"numbers", numbers},
          {"profile", profile}};
}

void list_solutions() {
  for (ExactSolution const& solution : exact_solutions())
    fmt::print("{:<15}{}\n", solution.name, solution.meaning);
  fmt::print("\nmoraine exact NAME --list says which parameters a solution has.\n");
}

void list_parameters(ExactSolution const& solution) {
  fmt::print("{}: {}\nsource: {}\n", solution.name, solution.meaning, solution.source);
  for (ExactParameter const& parameter : solution.parameters) {
    std::string choices;
    for (std::string_view const name : parameter.names)
      if (parameter.kind == ExactValueKind::choice)
        choices += fmt::format("{}{}", choices.empty() ? ": " : ", ", name);
    fmt::print("  {:<22}{:<22}{}{}\n", parameter.key,
               parameter.fallback.empty() ? "-" : parameter.fallback, parameter.meaning, choices);
  }
}

ExactAnswer solve(ExactSolution const& solution, ExactValues const& values) {
  try {
    return solution.solve(values);
  } catch (std::invalid_argument const& error) {
    refuse(solution.name, "", error.what(), "");
  } catch (std::domain_error const& error) {
    refuse(solution.name, "", error.what(), "");
  }
}

void check_picture(std::string const& path) {
  if (!path.empty() && !path.ends_with(".svg") && !path.ends_with(".png"))
    refuse("--plot", fmt::format("\"{}\"", path), "is no picture that can be drawn",
           "choose a name that ends with .svg or .png");
}

}  // namespace

std::vector<ExactSolution> const& exact_solutions() {
  static std::vector<ExactSolution> const all = [] {
    std::vector<ExactSolution> list = exact_gas_solutions();
    for (auto const& more : {exact_material_solutions(), exact_liquid_solutions()})
      list.insert(list.end(), more.begin(), more.end());
    return list;
  }();
  return all;
}

ExactSolution const& exact_solution(std::string_view name) {
  std::vector<std::string_view> names;
  for (ExactSolution const& solution : exact_solutions()) {
    if (solution.name == name) return solution;
    names.push_back(solution.name);
  }
  refuse("", fmt::format("\"{}\"", name), "is no exact solution", name_hint(name, names));
}

void add_exact(CLI::App& app, ExactOptions& options) {
  auto* command =
      app.add_subcommand("exact", "exact solutions: numbers, tables and pictures to compare with");
  command->add_option("name", options.name, "solution (default: list all)");
  command->add_flag("--list", options.list, "all solutions, or the parameters of one");
  command->add_option("--time", options.time, "time of the profile, as in \"10 us\"");
  command->add_option("--points", options.points, "points of the profile")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str();
  command->add_option("--parameters", options.parameters,
                      "key=value ..., SI numbers or with units, as in left_velocity=\"2 km/s\"");
  command->add_option("--csv", options.csv, "write the profile to this file, or to the output: -");
  command->add_flag("--json", options.json, "numbers and profile as JSON");
  command->add_option("--plot", options.plot, "draw the profile: a file .svg or .png");
}

int run_exact(ExactOptions const& options) {
  if (options.name.empty()) {
    list_solutions();
    return ExitCode::done;
  }
  ExactSolution const& solution = exact_solution(options.name);
  if (options.list) {
    list_parameters(solution);
    return ExitCode::done;
  }
  check_picture(options.plot);
  ExactValues const values =
      read_exact_values(solution, options.parameters, options.time, options.points);
  ExactAnswer const answer = solve(solution, values);
  if (!options.csv.empty() && options.csv != "-") write_csv(answer.profile, options.csv);
  if (!options.plot.empty()) draw(solution, answer.profile, options.plot);
  if (options.csv == "-")
    fmt::print("{}", csv_text(answer.profile));
  else if (options.json)
    fmt::print("{}\n", answer_json(solution, values, answer).dump(2));
  else
    fmt::print("{}", answer_text(solution, values, answer));
  return ExitCode::done;
}

}  // namespace moraine
