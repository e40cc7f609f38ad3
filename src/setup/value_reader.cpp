#include "setup/value_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace moraine {
namespace {

std::string_view kind_of(toml::node const& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number with decimals";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::string one_number(Parameter const& parameter) {
  auto const& quantity = info(parameter.quantity);
  if (parameter.quantity == Quantity::number) return "a number";
  return fmt::format("{} ({})", quantity.name, quantity.unit);
}

std::string with_unit(double value, Parameter const& parameter) {
  if (parameter.quantity == Quantity::number) return fmt::format("{}", value);
  return fmt::format("{} {}", value, info(parameter.quantity).unit);
}

// The broken rule, or nothing for a valid number.
std::string broken_limit(double value, Parameter const& parameter) {
  auto const& limits = parameter.limits;
  if (std::isnan(value)) return "is not a number";
  // "No bound" is infinity where there is a least value, else minus infinity.
  bool const no_bound = limits.infinity_allowed && (value > 0.0) == std::isfinite(limits.min);
  if (std::isinf(value) && !no_bound) return "must be finite";
  bool const low = limits.min_excluded ? value <= limits.min : value < limits.min;
  if (!low && value <= limits.max) return {};
  std::string const least = with_unit(limits.min, parameter);
  std::string const most = with_unit(limits.max, parameter);
  if (std::isinf(limits.max))
    return fmt::format("must be {} {}", limits.min_excluded ? "greater than" : "at least", least);
  if (std::isinf(limits.min)) return fmt::format("must be at most {}", most);
  if (limits.min_excluded) return fmt::format("must be greater than {}, at most {}", least, most);
  return fmt::format("must be between {} and {}", least, most);
}

class ValueReader {
 public:
  ValueReader(Parameter const& parameter, int dimension, std::string const& key, Source& source)
      : parameter_(parameter), dimension_(dimension), key_(key), source_(source) {}

  std::optional<Value> read(toml::node const& node) {
    switch (parameter_.type) {
      case ValueType::integer:
        return as_value(integer(node));
      case ValueType::real:
        return as_value(real(node));
      case ValueType::reals:
        return as_value(reals(node));
      case ValueType::vector:
        return as_value(vector(node));
      case ValueType::text:
        return as_value(text(node));
      case ValueType::choice:
      case ValueType::side:
        return as_value(name(node));
      case ValueType::axes:
      case ValueType::sides:
        return as_value(list_of_names(node));
      case ValueType::texts:
        return as_value(texts(node));
      case ValueType::corners:
        return as_value(corners(node));
      case ValueType::points:
        return as_value(points(node));
      case ValueType::shapes:
        if (!node.is_array()) wrong_kind(node, "a list of shapes, [{ ... }, ...],");
        break;
      case ValueType::shape_key:
        break;
    }
    return std::nullopt;
  }

 private:
  template <class T>
  static std::optional<Value> as_value(std::optional<T> value) {
    if (!value) return std::nullopt;
    return Value(std::move(*value));
  }

  std::nullopt_t wrong(toml::node const& node, std::string rule, std::string hint = {}) {
    source_.report_value(key_, stretch_of(node.source()), std::move(rule), std::move(hint));
    return std::nullopt;
  }

  std::nullopt_t wrong_kind(toml::node const& node, std::string_view expected) {
    return wrong(node, fmt::format("is {}; {} is expected", kind_of(node), expected));
  }

  std::optional<int> integer(toml::node const& node) {
    auto const number = node.value_exact<std::int64_t>();
    if (!number) return wrong_kind(node, "an integer");
    std::string const rule = broken_limit(static_cast<double>(*number), parameter_);
    if (!rule.empty()) return wrong(node, rule);
    return static_cast<int>(*number);
  }

  std::optional<double> real(toml::node const& node) {
    double value = 0.0;
    if (auto const text = node.value_exact<std::string>()) {
      Conversion conversion = to_si(*text, parameter_.quantity);
      if (!conversion.value)
        return wrong(node, std::move(conversion.rule), std::move(conversion.hint));
      value = *conversion.value;
    } else if (node.is_number()) {
      value = *node.value<double>();
    } else {
      return wrong_kind(node, one_number(parameter_));
    }
    std::string const rule = broken_limit(value, parameter_);
    if (!rule.empty()) return wrong(node, rule);
    return value;
  }

  std::optional<std::vector<double>> reals(toml::node const& node) {
    auto const* list = node.as_array();
    if (list == nullptr)
      return wrong_kind(node, fmt::format("a list, each {},", one_number(parameter_)));
    std::vector<double> values;
    for (auto const& item : *list)
      if (auto const value = real(item)) values.push_back(*value);
    if (values.size() != list->size()) return std::nullopt;
    return values;
  }

  std::optional<std::array<double, 3>> vector(toml::node const& node) {
    auto const* list = node.as_array();
    if (list == nullptr)
      return wrong_kind(node, fmt::format("a vector, each component {},", one_number(parameter_)));
    bool const right_size = dimension_ == 0 ? !list->empty() && list->size() <= 3
                                            : list->size() == static_cast<std::size_t>(dimension_);
    if (!right_size) {
      std::string const expected = dimension_ == 0 ? "1 to 3" : fmt::format("{}", dimension_);
      return wrong(node, fmt::format("has {} component{}; {} expected (space.dimension)",
                                     list->size(), list->size() == 1 ? "" : "s", expected));
    }
    auto const values = reals(node);
    if (!values) return std::nullopt;
    std::array<double, 3> result{};
    std::copy(values->begin(), values->end(), result.begin());
    return result;
  }

  std::optional<std::string> text(toml::node const& node) {
    auto value = node.value_exact<std::string>();
    if (!value) return wrong_kind(node, "a text");
    if (value->empty()) return wrong(node, "must not be empty");
    return value;
  }

  std::optional<std::vector<std::string>> texts(toml::node const& node) {
    auto const* list = node.as_array();
    if (list == nullptr) return wrong_kind(node, "a list of texts");
    std::vector<std::string> values;
    for (auto const& item : *list)
      if (auto value = text(item); value && known(*value, item))
        values.push_back(*std::move(value));
    if (values.size() != list->size()) return std::nullopt;
    return values;
  }

  /// Where a list has names, its texts are some of them.
  bool known(std::string const& value, toml::node const& node) {
    auto const& valid = parameter_.names;
    if (valid.empty() || std::find(valid.begin(), valid.end(), value) != valid.end()) return true;
    wrong(node, "is not a known name", name_hint(value, valid));
    return false;
  }

  std::optional<std::vector<double>> corners(toml::node const& node) {
    auto const* list = node.as_array();
    if (list == nullptr) return wrong_kind(node, "a list of corners, [[x, y], ...],");
    std::vector<double> values;
    for (auto const& item : *list) {
      auto const* pair = item.as_array();
      if (pair == nullptr || pair->size() != 2)
        return wrong(item, "is no corner; two numbers, [x, y], are expected");
      auto const corner = reals(item);
      if (corner) values.insert(values.end(), corner->begin(), corner->end());
    }
    if (values.size() != 2 * list->size()) return std::nullopt;
    return values;
  }

  std::optional<std::vector<double>> points(toml::node const& node) {
    auto const* list = node.as_array();
    if (list == nullptr || (!list->empty() && !list->front().is_array()))
      return wrong_kind(node, "a list of points, [[x, y], ...],");
    std::vector<double> values;
    for (auto const& item : *list)
      if (auto const point = vector(item))
        values.insert(values.end(), point->begin(), point->end());
    if (values.size() != 3 * list->size()) return std::nullopt;
    return values;
  }

  std::span<std::string_view const> names() const {
    auto const axes = static_cast<std::size_t>(dimension_ == 0 ? 3 : dimension_);
    if (parameter_.type == ValueType::axes) return std::span(axis_names).first(axes);
    if (parameter_.type == ValueType::side || parameter_.type == ValueType::sides)
      return std::span(side_names).first(2 * axes);
    return parameter_.names;
  }

  std::string_view kind_of_name() const {
    if (parameter_.type == ValueType::axes) return "an axis";
    return parameter_.type == ValueType::choice ? "a known name" : "a side";
  }

  std::optional<int> name(toml::node const& node) {
    auto const value = node.value_exact<std::string>();
    if (!value) return wrong_kind(node, "a text");
    auto const valid = names();
    auto const found = std::find(valid.begin(), valid.end(), *value);
    if (found == valid.end())
      return wrong(node, fmt::format("is not {}", kind_of_name()), name_hint(*value, valid));
    return static_cast<int>(found - valid.begin());
  }

  std::optional<std::vector<int>> list_of_names(toml::node const& node) {
    auto const* list = node.as_array();
    if (list == nullptr) return wrong_kind(node, "a list of texts");
    std::vector<int> indices;
    for (auto const& item : *list)
      if (auto const index = name(item)) indices.push_back(*index);
    if (indices.size() != list->size()) return std::nullopt;
    return indices;
  }

  Parameter const& parameter_;
  int dimension_;
  std::string const& key_;
  Source& source_;
};

}  // namespace

Stretch stretch_of(toml::source_region const& region) {
  return {region.begin.line, region.begin.column, region.end.line, region.end.column};
}

std::optional<Value> read_value(toml::node const& node, Parameter const& parameter, int dimension,
                                std::string const& key, Source& source) {
  return ValueReader(parameter, dimension, key, source).read(node);
}

}  // namespace moraine
