#include "setup/parameter.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstddef>
#include <span>

namespace moraine {
namespace {

std::string real_text(double value) {
  if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string_view name_of(int index, Parameter const& parameter) {
  auto const i = static_cast<std::size_t>(index);
  if (parameter.type == ValueType::axes) return axis_names[i];
  if (parameter.type == ValueType::side || parameter.type == ValueType::sides) return side_names[i];
  return parameter.names[i];
}

template <class Items, class ToText>
std::string list_text(Items const& items, ToText to_text) {
  std::string text;
  for (auto const& item : items) text += (text.empty() ? "" : ", ") + to_text(item);
  return "[" + text + "]";
}

struct ToToml {
  Parameter const& parameter;
  int dimension;

  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(double value) const { return real_text(value); }
  std::string operator()(int value) const {
    if (parameter.type == ValueType::integer) return fmt::format("{}", value);
    return quoted(name_of(value, parameter));
  }
  std::string operator()(std::string const& value) const { return quoted(value); }
  std::string operator()(std::array<double, 3> const& value) const {
    return list_text(std::span(value).first(static_cast<std::size_t>(dimension)), real_text);
  }
  std::string operator()(std::vector<double> const& value) const {
    if (parameter.type == ValueType::points) return points_text(value);
    if (parameter.type != ValueType::corners) return list_text(value, real_text);
    std::vector<std::array<double, 2>> corners;
    for (std::size_t i = 0; i + 1 < value.size(); i += 2)
      corners.push_back({value[i], value[i + 1]});
    return list_text(corners, [](auto const& corner) { return list_text(corner, real_text); });
  }
  std::string points_text(std::vector<double> const& value) const {
    std::vector<std::span<double const>> points;
    for (std::size_t i = 0; i + 2 < value.size(); i += 3)
      points.push_back(std::span(value).subspan(i, static_cast<std::size_t>(dimension)));
    return list_text(points, [](auto const& point) { return list_text(point, real_text); });
  }
  std::string operator()(std::vector<std::string> const& value) const {
    return list_text(value, [](std::string const& text) { return quoted(text); });
  }
  std::string operator()(std::vector<int> const& value) const {
    return list_text(value, [this](int index) { return quoted(name_of(index, parameter)); });
  }
};

}  // namespace

std::string full_key(Parameter const& parameter) {
  auto const& section = info(parameter.section);
  switch (section.repeat) {
    case Repeat::named:
      return fmt::format("{}.NAME.{}", section.key, parameter.key);
    case Repeat::list:
      return fmt::format("{}[].{}", section.key, parameter.key);
    case Repeat::once:
      break;
  }
  return std::string(parameter.key);
}

std::string to_toml(Value const& value, Parameter const& parameter, int dimension) {
  return std::visit(ToToml{parameter, dimension}, value);
}

}  // namespace moraine
