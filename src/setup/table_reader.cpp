#include "setup/table_reader.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "setup/parameter_table.hpp"
#include "setup/value_reader.hpp"

namespace moraine {
namespace {

// The node behind a dotted key; null where a part of the way is missing or no table.
toml::node const* find(toml::table const& table, std::string_view key) {
  auto const dot = key.find('.');
  toml::node const* node = table.get(key.substr(0, dot));
  if (node == nullptr || dot == std::string_view::npos) return node;
  auto const* inner = node->as_table();
  return inner != nullptr ? find(*inner, key.substr(dot + 1)) : nullptr;
}

std::string_view parent_of(std::string_view key) {
  auto const dot = key.rfind('.');
  return dot == std::string_view::npos ? std::string_view{} : key.substr(0, dot);
}

// "domain" for the key "space.domain.min" below the path "space".
std::string_view part_below(std::string_view key, std::string_view path) {
  if (!path.empty()) {
    if (!key.starts_with(path) || key.size() <= path.size() || key[path.size()] != '.') return {};
    key = key.substr(path.size() + 1);
  }
  return key.substr(0, key.find('.'));
}

std::string_view last_part(std::string_view key) {
  auto const dot = key.rfind('.');
  return dot == std::string_view::npos ? key : key.substr(dot + 1);
}

std::string listed(std::vector<std::string_view> const& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " or " : ", ", names[i]);
  return text;
}

}  // namespace

bool TableReader::applies(Parameter const& parameter) const {
  if (parameter.when_key.empty()) return true;
  auto const found = chosen_.find(parameter.when_key);
  return found != chosen_.end() && found->second == parameter.when_value;
}

bool TableReader::is_possible(Parameter const& parameter) const {
  return applies(parameter) || !chosen_.contains(parameter.when_key);
}

std::optional<Value> TableReader::read(Parameter const& parameter, int dimension) {
  std::optional<Value> value;
  if (parameter.type == ValueType::shape_key) {
    value = read_shape_key(parameter);
  } else if (toml::node const* node = find(table_, parameter.key)) {
    std::string const key = prefix_ + std::string(parameter.key);
    source_.remember(key, stretch_of(node->source()));
    if (auto const by = decided_.find(parameter.key); by != decided_.end()) {
      source_.report_value(key, fmt::format("is given together with {}", by->second),
                           "leave out one of the two");
      return std::nullopt;
    }
    value = read_value(*node, parameter, dimension, key, source_);
  } else {
    value = absent(parameter);
  }
  bool const choice = parameter.type == ValueType::choice || parameter.type == ValueType::shape_key;
  if (choice && value)
    chosen_[parameter.key] = parameter.names[static_cast<std::size_t>(std::get<int>(*value))];
  if (!parameter.decides.empty()) decide(parameter, value);
  return value;
}

void TableReader::decide(Parameter const& parameter, std::optional<Value> const& value) {
  if (find(table_, parameter.key) == nullptr) {
    instead_[parameter.decides] = parameter.key;
    return;
  }
  decided_[parameter.decides] = parameter.key;
  if (value)
    chosen_[parameter.decides] = parameter.decided[static_cast<std::size_t>(std::get<int>(*value))];
}

std::optional<Value> TableReader::read_shape_key(Parameter const& parameter) {
  std::vector<std::string_view> present;
  for (auto const name : parameter.names)
    if (table_.contains(name)) present.push_back(name);
  if (present.size() == 1) {
    auto const& names = parameter.names;
    return static_cast<int>(std::find(names.begin(), names.end(), present[0]) - names.begin());
  }
  auto const place = stretch_of(table_.source());
  std::string const key = prefix_.substr(0, prefix_.size() - 1);
  if (present.empty())
    source_.report_key(key, place, fmt::format("needs one of {}", listed(parameter.names)));
  else
    source_.report_key(
        key, place,
        fmt::format("has {} of {}; only one is possible", present.size(), listed(parameter.names)));
  return std::nullopt;
}

std::optional<Value> TableReader::absent(Parameter const& parameter) {
  if (decided_.contains(parameter.key) || decided_.contains(parameter.when_key))
    return std::nullopt;
  std::string_view const parent_key = parent_of(parameter.key);
  toml::node const* parent = parent_key.empty() ? &table_ : find(table_, parent_key);
  bool const not_a_table = parent != nullptr && !parent->is_table();  // reported by check_keys
  bool const needed = parameter.presence == Presence::required ||
                      (parameter.presence == Presence::with_table && parent != nullptr);
  if (needed && !not_a_table) {
    Stretch const place = parent != nullptr && parent->source().begin ? stretch_of(parent->source())
                                                                      : stretch_of(table_.source());
    bool const nowhere = parent == nullptr || (parent == &table_ && prefix_.empty());
    auto const other = instead_.find(parameter.key);
    source_.report_key(prefix_ + std::string(parameter.key), nowhere ? Stretch{} : place,
                       fmt::format("is missing: {}", parameter.meaning),
                       other == instead_.end() ? "" : fmt::format("or give {}", other->second));
  }
  if (needed || std::holds_alternative<std::monostate>(parameter.preset)) return std::nullopt;
  return parameter.preset;
}

void TableReader::check_keys(std::vector<Parameter const*> const& parameters,
                             std::span<std::string_view const> others) {
  check_keys_in(table_, "", parameters, others);
}

void TableReader::check_keys_in(toml::table const& table, std::string const& path,
                                std::vector<Parameter const*> const& parameters,
                                std::span<std::string_view const> others) {
  for (auto const& [key, node] : table) {
    std::string_view const name = key.str();
    if (std::find(others.begin(), others.end(), name) != others.end()) continue;
    std::string const full = path.empty() ? std::string(name) : path + '.' + std::string(name);
    bool leaf = false;
    bool branch = false;
    for (auto const* parameter : parameters) {
      if (parameter->type == ValueType::shape_key || !is_possible(*parameter)) continue;
      leaf = leaf || parameter->key == full;
      branch = branch || !part_below(parameter->key, full).empty();
    }
    if (leaf) continue;
    if (!branch)
      report_unknown(key, path, parameters, others);
    else if (auto const* inner = node.as_table())
      check_keys_in(*inner, full, parameters, {});
    else
      source_.report_value(prefix_ + full, stretch_of(node.source()), "must be a table");
  }
}

void TableReader::report_unknown(toml::key const& key, std::string const& path,
                                 std::vector<Parameter const*> const& parameters,
                                 std::span<std::string_view const> others) {
  std::string const full = path.empty() ? std::string(key.str()) : path + '.' + std::string(key);
  std::vector<std::string_view> names(others.begin(), others.end());
  std::string rule = "is an unknown key";
  std::string elsewhere;
  for (auto const* parameter : parameters) {
    if (parameter->type == ValueType::shape_key) continue;
    if (is_possible(*parameter)) {
      auto const name = part_below(parameter->key, path);
      bool const new_name = std::find(names.begin(), names.end(), name) == names.end();
      if (!name.empty() && new_name) names.push_back(name);
      if (last_part(parameter->key) == key.str()) elsewhere = prefix_ + std::string(parameter->key);
    } else if (parameter->key == full) {
      rule = fmt::format("does not belong to {} = \"{}\"", parameter->when_key,
                         chosen_.at(parameter->when_key));
    }
  }
  std::string hint;
  if (auto const name = nearest_name(key.str(), names); !name.empty())
    hint = fmt::format("did you mean \"{}\"?", name);
  else if (!elsewhere.empty())
    hint = fmt::format("did you mean \"{}\"?", elsewhere);
  source_.report_key(prefix_ + full, stretch_of(key.source()), rule, hint);
}

}  // namespace moraine
