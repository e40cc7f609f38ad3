#include "setup/parameter_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace moraine {
namespace {

constexpr int shown_dimension = 2;  // of vectors in texts that know no case

bool has_unit(Parameter const& parameter) { return parameter.quantity != Quantity::number; }

std::string with_unit(double value, Parameter const& parameter) {
  if (!has_unit(parameter)) return fmt::format("{}", value);
  return fmt::format("{} {}", value, info(parameter.quantity).unit);
}

template <class Names>
std::string quoted_list(Names const& names) {
  std::string text;
  for (auto const name : names) text += fmt::format("{}\"{}\"", text.empty() ? "" : ", ", name);
  return text;
}

std::string number_range(Parameter const& parameter) {
  auto const& limits = parameter.limits;
  std::string const least = with_unit(limits.min, parameter);
  std::string const most = with_unit(limits.max, parameter);
  bool const below = std::isinf(limits.min);
  bool const above = std::isinf(limits.max);
  if (below && above) return "any number";
  if (below) return fmt::format("at most {}", most);
  if (above) return fmt::format("{} {}", limits.min_excluded ? "greater than" : "at least", least);
  if (limits.min_excluded) return fmt::format("greater than {}, at most {}", least, most);
  return fmt::format("{} to {}", least, most);
}

bool allowed(double value, Limits const& limits) {
  bool const low = limits.min_excluded ? value <= limits.min : value < limits.min;
  return !low && value <= limits.max;
}

// A number inside the range: the default if it tells something, else one, else what is between.
double example_number(Parameter const& parameter) {
  auto const& limits = parameter.limits;
  if (auto const* preset = std::get_if<double>(&parameter.preset))
    if (*preset != 0.0 && std::isfinite(*preset)) return *preset;
  if (allowed(1.0, limits) && 1.0 > limits.min) return 1.0;
  if (std::isfinite(limits.min) && std::isfinite(limits.max))
    return 0.5 * (limits.min + limits.max);
  return std::isfinite(limits.min) ? limits.min + 1.0 : limits.max;
}

std::string example_real(Parameter const& parameter) {
  bool const preset = std::holds_alternative<double>(parameter.preset) &&
                      std::isfinite(std::get<double>(parameter.preset)) &&
                      std::get<double>(parameter.preset) != 0.0;
  if (!has_unit(parameter)) return fmt::format("{}", example_number(parameter));
  auto const& quantity = info(parameter.quantity);
  bool const plain = preset || quantity.usual[1].empty() || !allowed(0.0, parameter.limits);
  auto const unit =
      plain && parameter.quantity != Quantity::length ? quantity.unit : quantity.usual[1];
  double const one = allowed(1.0, parameter.limits) ? 1.0 : -1.0;
  double const number = preset ? example_number(parameter) : one;
  return fmt::format("\"{} {}\"", number, preset ? quantity.unit : unit);
}

}  // namespace

std::string unit_text(Parameter const& parameter) {
  if (!has_unit(parameter)) return "-";
  auto const& quantity = info(parameter.quantity);
  std::vector<std::string_view> others;
  for (auto const unit : quantity.usual)
    if (!unit.empty() && unit != quantity.unit) others.push_back(unit);
  if (others.empty()) return std::string(quantity.unit);
  return fmt::format("{} (also {})", quantity.unit, quoted_list(others));
}

std::string default_text(Parameter const& parameter) {
  if (!parameter.preset_note.empty()) return std::string(parameter.preset_note);
  std::string text = to_toml(parameter.preset, parameter, shown_dimension);
  if (text.empty()) {
    if (parameter.presence == Presence::required) return "none, must be given";
    if (parameter.presence == Presence::with_table) return "none, must be given with its table";
    return "none";
  }
  if (parameter.type == ValueType::vector) text = "zero";
  if (has_unit(parameter) && parameter.type != ValueType::reals)
    text += fmt::format(" {}", info(parameter.quantity).unit);
  return text;
}

std::string range_text(Parameter const& parameter) {
  switch (parameter.type) {
    case ValueType::integer:
      return "an integer, " + number_range(parameter);
    case ValueType::real:
      return number_range(parameter);
    case ValueType::reals:
      return "a list, each " + number_range(parameter);
    case ValueType::vector:
      return "a list of one component for each dimension, each " + number_range(parameter);
    case ValueType::text:
      return "a text that is not empty";
    case ValueType::choice:
      return "one of " + quoted_list(parameter.names);
    case ValueType::axes:
      return "a list of " + quoted_list(axis_names) + ", as far as the dimension goes";
    case ValueType::side:
      return "one of " + quoted_list(side_names) + ", as far as the dimension goes";
    case ValueType::sides:
      return "a list of " + quoted_list(side_names) + ", as far as the dimension goes";
    case ValueType::texts:
      return parameter.names.empty() ? "a list of texts that are not empty"
                                     : "a list of " + quoted_list(parameter.names);
    case ValueType::corners:
      return "a list of pairs, each " + number_range(parameter);
    case ValueType::points:
      return "a list of points, each component " + number_range(parameter);
    case ValueType::shapes:
      return "a list of tables, each with the keys of one shape";
    case ValueType::shape_key:
      return "exactly one of the keys " + quoted_list(parameter.names);
  }
  return {};
}

std::string example_value(Parameter const& parameter) {
  switch (parameter.type) {
    case ValueType::integer:
      return allowed(2.0, parameter.limits) ? "2"
                                            : fmt::format("{}", std::ceil(parameter.limits.min));
    case ValueType::real:
      return example_real(parameter);
    case ValueType::reals:
      return fmt::format("[{0}]", example_real(parameter));
    case ValueType::vector: {
      std::string const component = example_real(parameter);
      return fmt::format("[{0}, {0}]", component);
    }
    case ValueType::text:
      return parameter.key == "material" ? "\"water\"" : "\"my choice\"";
    case ValueType::choice:
      return fmt::format("\"{}\"", parameter.names.front());
    case ValueType::axes:
      return "[\"x\"]";
    case ValueType::side:
      return "\"x+\"";
    case ValueType::sides:
      return "[\"y+\"]";
    case ValueType::texts:
      return parameter.names.empty() ? "[\"sand\", \"clay\"]"
                                     : fmt::format("[\"{}\"]", parameter.names.front());
    case ValueType::corners: {
      std::string const number = example_real(parameter);
      return fmt::format("[[0, 0], [{0}, 0], [0, {0}]]", number);
    }
    case ValueType::points: {
      std::string const component = example_real(parameter);
      return fmt::format("[[{0}, {0}]]", component);
    }
    case ValueType::shapes:
      return "[{ disc = { center = [0, 0], radius = 1 } }]";
    case ValueType::shape_key:
      break;
  }
  return {};
}

std::string condition_text(Parameter const& parameter) {
  if (parameter.when_key.empty()) return {};
  if (parameter.key.substr(0, parameter.key.find('.')) == parameter.when_value)
    return fmt::format("a {}", parameter.when_value);
  return fmt::format("{} = \"{}\"", parameter.when_key, parameter.when_value);
}

}  // namespace moraine
