#include "sweep/case_template.hpp"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "output/manifest.hpp"
#include "setup/read_case.hpp"
#include "sweep/toml_text.hpp"

namespace moraine {
namespace {

/// The table that a key is in; null where the file has none of that kind.
toml::table* table_of(toml::table& root, CaseKey const& key) {
  if (key.section == Section::top) return &root;
  auto* section = root.get(info(key.section).key);
  if (section == nullptr) return nullptr;
  if (auto* named = section->as_table()) {
    auto* item = named->get(key.item);
    return item != nullptr ? item->as_table() : nullptr;
  }
  auto* list = section->as_array();
  if (list == nullptr) return nullptr;
  for (auto& node : *list)
    if (auto* table = node.as_table(); table && (*table)["name"].value_or("") == key.item)
      return table;
  return nullptr;
}

void put(toml::table& table, std::string_view inner, toml::node const& value) {
  auto const dot = inner.find('.');
  if (dot == std::string_view::npos) {
    value.visit([&](auto const& node) { table.insert_or_assign(inner, node); });
    return;
  }
  std::string_view const first = inner.substr(0, dot);
  auto* node = table.get(first);
  if (node == nullptr || !node->is_table()) {
    toml::table made;
    made.is_inline(true);
    node = &table.insert_or_assign(first, std::move(made)).first->second;
  }
  put(*node->as_table(), inner.substr(dot + 1), value);
}

toml::table replaced(std::string const& text, std::span<Replacement const> replacements) {
  toml::table root = toml::parse(text);
  for (auto const& [key, value] : replacements) {
    toml::table const holder = toml::parse("value = " + value);
    if (auto* table = table_of(root, key)) put(*table, key.inner, *holder.get("value"));
  }
  return root;
}

/// The standard's function wants both to be there.
std::string relative_to(std::filesystem::path const& path, std::filesystem::path const& folder) {
  return std::filesystem::relative(std::filesystem::absolute(path),
                                   std::filesystem::absolute(folder))
      .string();
}

/// Names of files in a case, counted from another folder.
class MovedFiles {
 public:
  MovedFiles(std::filesystem::path from, std::filesystem::path to)
      : from_(std::move(from)), to_(std::move(to)) {}

  void move(toml::table& root) {
    move_name(root.get_as<toml::table>("start"), "run", false);
    for (char const* list : {"region", "wall", "reference"})
      move_in_list(root.get_as<toml::array>(list));
  }
  std::string const& digests() const { return digests_; }

 private:
  void move_in_list(toml::array* list) {
    if (list == nullptr) return;
    for (auto& node : *list) {
      auto* table = node.as_table();
      if (table == nullptr) continue;
      move_name(table, "file", true);
      move_name(table->get_as<toml::table>("stl"), "file", true);
      move_name(table->get_as<toml::table>("motion"), "file", true);
      for (char const* inner : {"plus", "minus"}) move_in_list(table->get_as<toml::array>(inner));
    }
  }

  void move_name(toml::table* table, std::string_view key, bool is_file) {
    if (table == nullptr) return;
    auto const* name = table->get_as<std::string>(key);
    if (name == nullptr) return;
    std::filesystem::path path = name->get();
    if (path.is_relative()) path = from_ / path;
    std::string const moved =
        std::filesystem::path(name->get()).is_relative() ? relative_to(path, to_) : path.string();
    if (is_file) digests_ += fmt::format("# {} has the SHA-256 {}\n", moved, file_sha256(path));
    table->insert_or_assign(key, moved);
  }

  std::filesystem::path from_;
  std::filesystem::path to_;
  std::string digests_;
};

std::string text_of(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

CaseTemplate::CaseTemplate(std::filesystem::path file)
    : file_(std::move(file)), text_(text_of(file_)), base_(read_case(file_)) {}

Case CaseTemplate::with(std::span<Replacement const> replacements) const {
  return parse_case(file_text(replaced(text_, replacements)), file_.string());
}

std::string CaseTemplate::text(std::span<Replacement const> replacements,
                               std::filesystem::path const& folder) const {
  toml::table root = replaced(text_, replacements);
  MovedFiles files(file_.parent_path().empty() ? "." : file_.parent_path(), folder);
  files.move(root);
  return "# A member of a sweep, made by moraine sweep.\n" + files.digests() + file_text(root);
}

}  // namespace moraine
