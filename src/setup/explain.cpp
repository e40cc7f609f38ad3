#include "setup/explain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <vector>

#include "base/input_error.hpp"
#include "setup/parameter_table.hpp"
#include "setup/parameter_text.hpp"

namespace moraine {
namespace {

// "region.velocity": the key without the name or the number of its item.
std::string short_key(Parameter const& parameter) {
  auto const section = info(parameter.section).key;
  return section.empty() ? std::string(parameter.key)
                         : fmt::format("{}.{}", section, parameter.key);
}

std::vector<std::string> parts_of(std::string_view key) {
  std::vector<std::string> parts{""};
  int depth = 0;
  for (char const c : key) {
    depth += c == '[' ? 1 : 0;
    if (depth == 0 && c == '.') {
      parts.emplace_back();
    } else if (depth == 0) {
      parts.back() += c;
    }
    depth -= c == ']' && depth > 0 ? 1 : 0;
  }
  return parts;
}

std::string joined(std::vector<std::string> const& parts) {
  std::string text;
  for (auto const& part : parts) text += (text.empty() ? "" : ".") + part;
  return text;
}

bool is_key_or_table(std::string_view key) {
  for (auto const* parameter : all_parameters()) {
    std::string const known = short_key(*parameter);
    if (known == key || known.starts_with(std::string(key) + '.')) return true;
  }
  return false;
}

// The key in short form: without [..], and without the second part where that is a name.
std::string normal_key(std::string_view key) {
  auto parts = parts_of(key);
  std::string const plain = joined(parts);
  if (parts.size() < 2 || is_key_or_table(plain)) return plain;
  for (auto const& section : section_table)
    if (!section.key.empty() && section.key == parts[0]) {
      parts.erase(parts.begin() + 1);
      return joined(parts);
    }
  return plain;
}

std::string line(std::string_view label, std::string const& text) {
  return text.empty() ? std::string{} : fmt::format("  {:<9}{}\n", label, text);
}

std::string example_line(Parameter const& parameter) {
  std::string const value = example_value(parameter);
  return value.empty() ? value : fmt::format("{} = {}", parameter.key, value);
}

std::string explained(Parameter const& parameter) {
  std::string text = fmt::format("{}\n  {}\n", full_key(parameter), parameter.meaning);
  text += line("where", condition_text(parameter));
  text += line("unit", unit_text(parameter));
  text += line("default", default_text(parameter));
  text += line("range", range_text(parameter));
  text += line("source", std::string(parameter.source));
  text += line("example", example_line(parameter));
  return text;
}

std::string key_list(std::string_view table) {
  std::string text;
  for (auto const* parameter : all_parameters()) {
    std::string const key = short_key(*parameter);
    if (!table.empty() && !key.starts_with(std::string(table) + '.')) continue;
    std::string const condition = condition_text(*parameter);
    text += fmt::format("  {:<34} {}{}\n", full_key(*parameter), parameter->meaning,
                        condition.empty() ? "" : fmt::format(" (where {})", condition));
  }
  return text;
}

std::string all_tables() {
  std::string text = "tables and keys of a case file; moraine explain KEY says more\n";
  for (auto const& section : section_table) {
    if (section.key.empty()) continue;
    std::string const name = section.repeat == Repeat::named ? fmt::format("[{}.NAME]", section.key)
                                                             : fmt::format("[[{}]]", section.key);
    text += fmt::format("  {:<20} {}\n", name, section.meaning);
  }
  return text + key_list("");
}

[[noreturn]] void refuse(std::string_view key) {
  std::vector<std::string> known;
  for (auto const* parameter : all_parameters()) known.push_back(short_key(*parameter));
  std::size_t const keys = known.size();
  for (std::size_t i = 0; i < keys; ++i)  // and the tables that hold them
    if (auto const dot = known[i].find('.'); dot != std::string::npos)
      known.push_back(known[i].substr(0, dot));
  std::vector<std::string_view> names(known.begin(), known.end());
  std::string const normal = normal_key(key);
  std::string hint;
  if (auto const name = nearest_name(normal, names); !name.empty())
    hint = fmt::format("did you mean \"{}\"?", name);
  // The last part alone may be right: "spacing" for "resolution.spacing".
  std::string const last = parts_of(normal).back();
  for (auto const& name : known)
    if (hint.empty() && parts_of(name).back() == last)
      hint = fmt::format("did you mean \"{}\"?", name);
  throw InputErrors({{.file = "moraine explain",
                      .line = 0,
                      .column = 0,
                      .key = "",
                      .value = fmt::format("\"{}\"", key),
                      .rule = "is no key of a case file",
                      .hint = hint.empty() ? "moraine explain lists all keys" : hint}});
}

}  // namespace

std::string explain(std::string_view key) {
  if (key.empty()) return all_tables();
  std::string const wanted = normal_key(key);
  std::string text;
  for (auto const* parameter : all_parameters())
    if (short_key(*parameter) == wanted) text += explained(*parameter);
  if (!text.empty()) return text;
  std::string const keys = key_list(wanted);
  if (keys.empty()) refuse(key);
  std::string meaning;
  for (auto const& section : section_table)
    if (section.key == wanted) meaning = fmt::format(": {}", section.meaning);
  return fmt::format("{}{}\n{}", wanted, meaning, keys);
}

}  // namespace moraine
