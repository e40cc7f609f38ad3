#include "sweep/read_axis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "setup/table_reader.hpp"
#include "setup/value_reader.hpp"
#include "sweep/sweep_tables.hpp"
#include "sweep/toml_text.hpp"

namespace moraine {
namespace {

constexpr std::array<std::string_view, 5> other_keys{"key", "keys", "values", "range", "label"};

std::string unit_of(Parameter const& parameter) {
  bool const number = parameter.type == ValueType::real;
  if (!number || parameter.quantity == Quantity::number) return {};
  return std::string(info(parameter.quantity).unit);
}

/// A number in SI, or else a text.
std::variant<double, std::string> shown(Value const& value, Parameter const& parameter,
                                        int dimension) {
  if (auto const* number = std::get_if<double>(&value)) return *number;
  if (auto const* text = std::get_if<std::string>(&value)) return *text;
  auto const* index = std::get_if<int>(&value);
  if (index != nullptr && parameter.type == ValueType::integer) return static_cast<double>(*index);
  if (index != nullptr && parameter.type == ValueType::choice)
    return std::string(parameter.names[static_cast<std::size_t>(*index)]);
  return to_toml(value, parameter, dimension);
}

class AxisReader {
 public:
  AxisReader(toml::table const& table, std::string const& prefix, AxisContext const& context,
             Source& source)
      : table_(table), prefix_(prefix), context_(context), source_(source) {}

  std::optional<SweepAxis> read() {
    read_table(TableReader(table_, prefix_, source_), axis_entries(), head_,
               context_.base.dimension, other_keys);
    for (char const* key : {"steps", "scale"}) good_ = good_ && !source_.has_problem(prefix_ + key);
    read_keys();
    read_labels();
    if (bool const values = table_.contains("values"); values == table_.contains("range"))
      wrong_table(values ? "has both values and range" : "needs values, or range with steps");
    else if (values)
      read_values();
    else
      read_range();
    if (!good_) return std::nullopt;
    if (axis_.range) axis_.range->logarithmic = logarithmic();
    axis_.logarithmic = logarithmic();
    return std::move(axis_);
  }

 private:
  bool logarithmic() const { return head_.scale == RangeScale::log; }

  void wrong(toml::node const& node, std::string const& key, std::string rule,
             std::string hint = {}) {
    source_.report_value(key, stretch_of(node.source()), std::move(rule), std::move(hint));
    good_ = false;
  }

  void wrong_table(std::string rule, std::string hint = {}) {
    source_.report_key(prefix_.substr(0, prefix_.size() - 1), stretch_of(table_.source()),
                       std::move(rule), std::move(hint));
    good_ = false;
  }

  void read_keys() {
    auto const* one = table_.get("key");
    auto const* several = table_.get("keys");
    if ((one == nullptr) == (several == nullptr))
      return wrong_table(one != nullptr ? "has both key and keys" : "needs a key",
                         one != nullptr ? "" : "such as key = \"resolution.spacing\"");
    if (one != nullptr) return read_key(*one, prefix_ + "key");
    auto const* list = several->as_array();
    if (list == nullptr || list->empty())
      return wrong(*several, prefix_ + "keys", "must be a list of keys");
    for (auto const& node : *list) read_key(node, prefix_ + "keys");
  }

  void read_key(toml::node const& node, std::string const& name) {
    auto const path = node.value_exact<std::string>();
    if (!path) return wrong(node, name, "must be the path of a key", "such as \"time.end\"");
    auto found = find_key(*path, context_.base);
    if (auto const* mistake = std::get_if<KeyMistake>(&found))
      return wrong(node, name, mistake->rule, mistake->hint);
    auto& key = std::get<CaseKey>(found);
    std::string const unit = unit_of(*key.parameter);
    axis_.columns.push_back({std::move(key), *path, unit});
  }

  void read_labels() {
    auto const* node = table_.get("label");
    if (node == nullptr) return;
    if (auto const text = node->value_exact<std::string>(); text && axis_.columns.size() < 2) {
      if (!axis_.columns.empty()) axis_.columns.front().label = *text;
      return;
    }
    auto const* list = node->as_array();
    if (list == nullptr || !table_.contains("keys"))
      return wrong(*node, prefix_ + "label",
                   table_.contains("keys") ? "must be a list of texts, one for each of the keys"
                                           : "must be a text");
    if (!good_) return;
    if (list->size() != axis_.columns.size())
      return wrong(*node, prefix_ + "label",
                   fmt::format("has {} texts for {} keys", list->size(), axis_.columns.size()));
    for (std::size_t i = 0; i < list->size(); ++i)
      axis_.columns[i].label = list->get(i)->value_or(axis_.columns[i].label);
  }

  void read_values() {
    auto const* list = table_.get("values")->as_array();
    if (list == nullptr || list->empty())
      return wrong(*table_.get("values"), prefix_ + "values", "must be a list of values");
    if (head_.steps) wrong_table("has steps, which belong to a range");
    if (axis_.columns.empty() || !good_) return;
    for (auto const& node : *list) read_row(node);
  }

  void read_row(toml::node const& node) {
    if (!table_.contains("keys")) {
      if (auto value = read_one(node, axis_.columns.front()))
        axis_.values.push_back({std::move(*value)});
      return;
    }
    auto const* row = node.as_array();
    if (row == nullptr || row->size() != axis_.columns.size())
      return wrong(node, prefix_ + "values",
                   fmt::format("must be a list of {} values, one for each of the keys",
                               axis_.columns.size()));
    std::vector<SweepValue> values;
    for (std::size_t i = 0; i < row->size(); ++i)
      if (auto value = read_one(*row->get(i), axis_.columns[i])) values.push_back(*value);
    if (values.size() == row->size()) axis_.values.push_back(std::move(values));
  }

  /// Where the dimension itself changes, vectors may have any number of components.
  int dimension() const {
    bool const changes = std::any_of(axis_.columns.begin(), axis_.columns.end(),
                                     [](auto const& c) { return c.key.path == "space.dimension"; });
    return changes ? 0 : context_.base.dimension;
  }

  std::optional<SweepValue> read_one(toml::node const& node, SweepColumn const& column) {
    Parameter const& parameter = *column.key.parameter;
    Stretch const place = stretch_of(node.source());
    std::string const text = value_text(node);
    if (parameter.type == ValueType::shapes && node.is_array())
      return SweepValue{text, text, place};
    auto const value = read_value(node, parameter, dimension(), column.key.path, source_);
    if (!value) {
      good_ = false;
      return std::nullopt;
    }
    bool const vector = std::holds_alternative<std::array<double, 3>>(*value);
    auto seen = vector && dimension() == 0 ? text : shown(*value, parameter, dimension());
    auto const* number = std::get_if<double>(&seen);
    if (number != nullptr && logarithmic() && *number <= 0.0)
      wrong(node, column.key.path, "has no place on a logarithmic scale; it must be above 0");
    return SweepValue{text, std::move(seen), place};
  }

  void read_range() {
    toml::node const& node = *table_.get("range");
    axis_.range_place = stretch_of(node.source());
    bool const drawn = context_.method == SweepMethod::latin_hypercube;
    if (context_.method && !drawn && !table_.contains("steps"))
      wrong_table("needs steps: how many values its range gives");
    if (drawn && table_.contains("steps"))
      wrong_table("has steps; a latin hypercube draws as many values as it has samples");
    auto const* list = node.as_array();
    if (list == nullptr || list->size() != 2)
      return wrong(node, prefix_ + "range", "must be a list of two numbers, the ends of the range");
    if (axis_.columns.empty() || !can_have_range(node)) return;
    std::array<double, 2> ends{};
    for (std::size_t i = 0; i < 2; ++i) {
      auto const value = read_one(*list->get(i), axis_.columns.front());
      if (!value) return;
      ends[i] = std::get<double>(value->shown);
    }
    axis_.range = ValueRange{ends[0], ends[1], logarithmic()};
    if (!drawn && head_.steps && good_) spread(node);
  }

  bool can_have_range(toml::node const& node) {
    for (SweepColumn const& column : axis_.columns) {
      Parameter const& parameter = *column.key.parameter;
      Parameter const& first = *axis_.columns.front().key.parameter;
      std::string rule;
      if (parameter.type != ValueType::real && parameter.type != ValueType::integer)
        rule = fmt::format("is a range, but {} takes no numbers", column.key.path);
      else if (parameter.quantity != first.quantity)
        rule =
            fmt::format("is a range of {} for {} too", info(first.quantity).name, column.key.path);
      if (rule.empty()) continue;
      wrong(node, prefix_ + "range", rule, "give values");
      return false;
    }
    return true;
  }

  void spread(toml::node const& node) {
    std::size_t same = 0;
    for (double const number : even_values(*axis_.range, static_cast<std::size_t>(*head_.steps))) {
      auto values = values_of(axis_, number);
      if (!axis_.values.empty() && are_same(axis_.values.back(), values)) ++same;
      axis_.values.push_back(std::move(values));
    }
    if (same > 0)
      wrong(node, prefix_ + "range",
            fmt::format("gives {} different values only, not {}", axis_.values.size() - same,
                        axis_.values.size()),
            "take fewer steps, or another range");
  }

  static bool are_same(std::vector<SweepValue> const& a, std::vector<SweepValue> const& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](SweepValue const& x, SweepValue const& y) { return x.shown == y.shown; });
  }

  toml::table const& table_;
  std::string const& prefix_;
  AxisContext const& context_;
  Source& source_;
  AxisHead head_;
  SweepAxis axis_;
  bool good_ = true;
};

}  // namespace

std::vector<SweepValue> values_of(SweepAxis const& axis, double number) {
  std::vector<SweepValue> values;
  for (SweepColumn const& column : axis.columns) {
    Parameter const& parameter = *column.key.parameter;
    bool const whole = parameter.type == ValueType::integer;
    double const rounded = whole ? std::round(number) : number;
    Value const value = whole ? Value(static_cast<int>(rounded)) : Value(rounded);
    values.push_back({to_toml(value, parameter, 0), rounded, axis.range_place});
  }
  return values;
}

std::optional<SweepAxis> read_axis(toml::table const& table, std::string const& prefix,
                                   AxisContext const& context, Source& source) {
  return AxisReader(table, prefix, context, source).read();
}

}  // namespace moraine
