// What `moraine exact` knows about an exact solution.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/units.hpp"
#include "matter/eos/eos.hpp"
#include "output/table_csv.hpp"

namespace moraine {

/// What the value of a parameter is.
enum class ExactValueKind {
  number,     // of a dimension
  material,   // the name of a shipped material, or one of `names`
  explosive,  // the name of a shipped material whose equation of state is jwl
  choice      // one of `names`
};

/// Which numbers a parameter may have.
enum class ExactRange { any, not_negative, positive };

/// A parameter of a solution. `fallback` is written as a user would; empty: what it is then, the
/// meaning says.
struct ExactParameter {
  std::string_view key;
  std::string_view fallback;
  std::string_view meaning;
  ExactValueKind kind = ExactValueKind::number;
  Dimension dimension = {"a plain number", "1", {}};
  ExactRange range = ExactRange::any;
  std::vector<std::string_view> names = {};
};

/// A parameter of one of the quantities of case files.
ExactParameter exact_number(std::string_view key, std::string_view fallback, Quantity quantity,
                            ExactRange range, std::string_view meaning);
/// The name of a shipped material, or one of `others` in its place.
ExactParameter exact_material(std::string_view key, std::string_view fallback,
                              std::string_view meaning, std::vector<std::string_view> others = {});
/// The name of a shipped explosive.
ExactParameter exact_explosive(std::string_view meaning);
ExactParameter exact_choice(std::string_view key, std::vector<std::string_view> names,
                            std::string_view fallback, std::string_view meaning);

/// Values of all parameters of a solution, in SI units.
struct ExactValues {
  std::map<std::string, double, std::less<>> numbers;     // those without a value are not in it
  std::map<std::string, std::string, std::less<>> texts;  // materials, choices
  int points = 0;                                         // of the profile

  double number(std::string_view key) const { return numbers.find(key)->second; }
  std::string const& text(std::string_view key) const { return texts.find(key)->second; }
  bool has(std::string_view key) const { return numbers.contains(key); }
};

/// A number of a solution.
struct ExactNumber {
  std::string name;
  double value;
  std::string unit;
};

/// What a solution answers. The first column of the profile is the axis.
struct ExactAnswer {
  std::vector<ExactNumber> numbers;
  Table profile;
};

/// `solve` throws std::invalid_argument or std::domain_error for values that have no solution.
struct ExactSolution {
  std::string name;
  std::string meaning;
  std::string source;
  std::vector<ExactParameter> parameters;  // among them "time", where the solution has one
  std::function<ExactAnswer(ExactValues const&)> solve;
};

/// Solutions by subject; all of them together, in the order of the list.
std::vector<ExactSolution> exact_gas_solutions();
std::vector<ExactSolution> exact_material_solutions();
std::vector<ExactSolution> exact_liquid_solutions();
std::vector<ExactSolution> const& exact_solutions();

/// Throws InputErrors with the nearest name for a name that there is not.
ExactSolution const& exact_solution(std::string_view name);

/// Values from texts `key=value`; `time` is that of the parameter "time" unless empty. Throws
/// InputErrors with all mistakes.
ExactValues read_exact_values(ExactSolution const& solution, std::vector<std::string> const& texts,
                              std::string const& time, int points);

/// Throws std::invalid_argument naming the parameters unless density [kg/m^3] and specific energy
/// [J/kg] of a material follow from `<prefix>density`, `<prefix>pressure`, `<prefix>energy`: with a
/// pressure and a density the energy is solved for, with a pressure the density; what is still
/// missing is the material's reference value.
struct MaterialPoint {
  double density;
  double specific_energy;
};
MaterialPoint material_point(ExactValues const& values, std::string const& prefix, Eos const& eos);

/// `count` values from `low` to `high`.
std::vector<double> even_steps(double low, double high, int count);

}  // namespace moraine
