#include "app/exact_profile.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace moraine {
namespace {

void add_wave(std::vector<ExactNumber>& numbers, std::string const& side, Wave const& wave,
              double time, double origin) {
  auto const add = [&](std::string const& what, double speed) {
    numbers.push_back({fmt::format("{} {}: speed", side, what), speed, "m/s"});
    numbers.push_back({fmt::format("{} {}: position", side, what), origin + speed * time, "m"});
  };
  if (wave.kind == WaveKind::shock) {
    add("shock", wave.head);
  } else {
    add("rarefaction, head", wave.head);
    add("rarefaction, tail", wave.tail);
  }
  numbers.push_back(
      {fmt::format("density behind the {} wave", side), wave.behind.density, "kg/m^3"});
  numbers.push_back({fmt::format("specific energy behind the {} wave", side),
                     wave.behind.specific_energy, "J/kg"});
}

}  // namespace

Table table_of(std::vector<TableColumn> columns) {
  std::size_t const count = columns.size();
  return {std::move(columns), std::vector<std::vector<double>>(count)};
}

void add_row(Table& table, std::initializer_list<double> row) {
  std::size_t k = 0;
  for (double const value : row) table.values[k++].push_back(value);
}

Table flow_profile(std::string const& axis, std::vector<double> const& x,
                   std::function<FlowState(double)> const& sample) {
  Table table = table_of({{axis, "m"},
                          {"density", "kg/m^3"},
                          {"velocity", "m/s"},
                          {"pressure", "Pa"},
                          {"specific_energy", "J/kg"}});
  for (double const place : x) {
    FlowState const at = sample(place);
    add_row(table, {place, at.density, at.velocity, at.pressure, at.specific_energy});
  }
  return table;
}

std::vector<ExactNumber> riemann_numbers(RiemannProblem const& solution, double time,
                                         double origin) {
  std::vector<ExactNumber> numbers;
  numbers.push_back({"pressure between the waves", solution.star_pressure(), "Pa"});
  bool const vacuum = !solution.right_wave();
  numbers.push_back({vacuum ? "velocity of the surface" : "velocity of the contact",
                     solution.star_velocity(), "m/s"});
  numbers.push_back({vacuum ? "position of the surface" : "position of the contact",
                     origin + solution.star_velocity() * time, "m"});
  add_wave(numbers, "left", solution.left_wave(), time, origin);
  if (!vacuum) add_wave(numbers, "right", *solution.right_wave(), time, origin);
  return numbers;
}

std::vector<double> riemann_places(RiemannProblem const& solution, double time, double origin,
                                   int count) {
  double const low = std::min(0.0, solution.left_wave().head);
  double const high =
      std::max(0.0, solution.right_wave() ? solution.right_wave()->head : solution.star_velocity());
  double const margin = 0.15 * (high - low);
  return even_steps(origin + (low - margin) * time, origin + (high + margin) * time, count);
}

}  // namespace moraine
