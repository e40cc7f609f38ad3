#include "sweep/toml_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <tuple>
#include <utility>
#include <vector>

#include "setup/parameter.hpp"

namespace moraine {
namespace {

using Item = std::pair<toml::key const*, toml::node const*>;

std::string quoted(std::string_view text) {
  return to_toml(Value(std::string(text)), Parameter{.type = ValueType::text}, 0);
}

std::string key_text(std::string_view key) {
  bool const bare =
      !key.empty() &&
      key.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") ==
          std::string_view::npos;
  return bare ? std::string(key) : quoted(key);
}

std::vector<Item> in_order(toml::table const& table) {
  std::vector<Item> items;
  for (auto const& [key, node] : table) items.emplace_back(&key, &node);
  auto const place = [](Item const& item) {
    auto const begin = item.first->source().begin;
    auto const line = begin.line > 0 ? begin.line : std::numeric_limits<toml::source_index>::max();
    return std::pair(line, begin.column);
  };
  std::stable_sort(items.begin(), items.end(),
                   [&](Item const& a, Item const& b) { return place(a) < place(b); });
  return items;
}

std::string inline_table(toml::table const& table) {
  std::string text;
  for (auto const& [key, node] : in_order(table))
    text +=
        fmt::format("{}{} = {}", text.empty() ? "" : ", ", key_text(key->str()), value_text(*node));
  return text.empty() ? "{}" : "{ " + text + " }";
}

std::string array_text(toml::array const& array) {
  std::string text;
  for (auto const& node : array) text += (text.empty() ? "" : ", ") + value_text(node);
  return "[" + text + "]";
}

bool is_section(toml::node const& node) {
  auto const* table = node.as_table();
  return table != nullptr && !table->is_inline();
}

bool is_list_of_sections(toml::node const& node) {
  auto const* array = node.as_array();
  return array != nullptr && !array->empty() &&
         std::all_of(array->begin(), array->end(), is_section);
}

class FileWriter {
 public:
  void write(toml::table const& table, std::string const& path) {
    auto const items = in_order(table);
    for (auto const& [key, node] : items)
      if (!is_section(*node) && !is_list_of_sections(*node))
        text_ += fmt::format("{} = {}\n", key_text(key->str()), value_text(*node));
    for (auto const& [key, node] : items) {
      std::string const full = (path.empty() ? "" : path + '.') + key_text(key->str());
      if (is_section(*node)) {
        section(fmt::format("[{}]", full), *node->as_table(), full);
      } else if (is_list_of_sections(*node)) {
        for (auto const& item : *node->as_array())
          section(fmt::format("[[{}]]", full), *item.as_table(), full);
      }
    }
  }
  std::string take() { return std::move(text_); }

 private:
  void section(std::string const& header, toml::table const& table, std::string const& path) {
    text_ += fmt::format("\n{}\n", header);
    write(table, path);
  }

  std::string text_;
};

}  // namespace

std::string value_text(toml::node const& node) {
  if (auto const* text = node.as_string()) return quoted(text->get());
  if (auto const* number = node.as_integer()) return fmt::format("{}", number->get());
  if (auto const* number = node.as_floating_point()) return to_toml(number->get(), Parameter{}, 0);
  if (auto const* boolean = node.as_boolean()) return boolean->get() ? "true" : "false";
  if (auto const* array = node.as_array()) return array_text(*array);
  if (auto const* table = node.as_table()) return inline_table(*table);
  std::ostringstream stream;  // dates and times
  stream << toml::toml_formatter{node};
  return stream.str();
}

std::string file_text(toml::table const& table) {
  FileWriter writer;
  writer.write(table, "");
  return writer.take();
}

}  // namespace moraine
