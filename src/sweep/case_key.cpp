#include "sweep/case_key.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <vector>

#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

/// Keys of one table, told apart by what a case holds there.
template <class Target>
class KeySearch {
 public:
  KeySearch(std::span<Entry<Target> const> entries, Target const& target)
      : entries_(entries), target_(target) {}

  Parameter const* find(std::string_view inner) const {
    Parameter const* found = nullptr;
    for (auto const& entry : entries_) {
      if (entry.parameter.key != inner || entry.parameter.type == ValueType::shape_key) continue;
      bool const held = !std::holds_alternative<std::monostate>(entry.get(target_));
      if (found == nullptr || held) found = &entry.parameter;
      if (held) break;
    }
    return found;
  }

  std::vector<std::string_view> names() const {
    std::vector<std::string_view> names;
    for (auto const& entry : entries_)
      if (entry.parameter.type != ValueType::shape_key) names.push_back(entry.parameter.key);
    return names;
  }

 private:
  std::span<Entry<Target> const> entries_;
  Target const& target_;
};

KeyMistake unknown(std::string_view prefix, std::string_view inner,
                   std::vector<std::string_view> const& names) {
  for (std::string_view const name : names)
    if (name.size() > inner.size() && name.starts_with(inner) && name[inner.size()] == '.')
      return {"is a table", fmt::format("name one of its keys, such as \"{}{}\"", prefix, name)};
  std::string_view const best = nearest_name(inner, names);
  if (best.empty()) return {"is no key of a case", "moraine explain lists all keys"};
  return {"is no key of a case", fmt::format("did you mean \"{}{}\"?", prefix, best)};
}

template <class Target>
std::variant<CaseKey, KeyMistake> key_in(std::string_view path, Section section,
                                         std::string_view item, std::string_view inner,
                                         std::span<Entry<Target> const> entries,
                                         Target const& target) {
  KeySearch<Target> const search(entries, target);
  std::string_view const prefix = path.substr(0, path.size() - inner.size());
  bool const name = inner == "name" && info(section).repeat == Repeat::list;
  if (name) return KeyMistake{"is a name, which a sweep cannot change", ""};
  auto const* parameter = search.find(inner);
  if (parameter == nullptr) return unknown(prefix, inner, search.names());
  return CaseKey{std::string(path), section, std::string(item), std::string(inner), parameter};
}

template <class Spec>
std::variant<CaseKey, KeyMistake> key_of_item(std::string_view path, Section section,
                                              std::span<Entry<Spec> const> entries,
                                              std::vector<Spec> const& specs) {
  std::string_view const rest = path.substr(path.find('.') + 1);
  Spec const* found = nullptr;
  std::vector<std::string_view> names;
  for (Spec const& spec : specs) {
    names.push_back(spec.name);
    bool const fits = rest.size() > spec.name.size() + 1 && rest.starts_with(spec.name) &&
                      rest[spec.name.size()] == '.';
    if (fits && (found == nullptr || spec.name.size() > found->name.size())) found = &spec;
  }
  std::string_view const kind = info(section).key;
  if (found == nullptr) {
    std::string_view const wanted = rest.substr(0, rest.find('.'));
    std::string const rule = fmt::format("names no {} of the case", kind);
    if (names.empty()) return KeyMistake{rule, fmt::format("the case has no {}", kind)};
    return KeyMistake{rule, name_hint(wanted, names)};
  }
  return key_in(path, section, found->name, rest.substr(found->name.size() + 1), entries, *found);
}

}  // namespace

std::variant<CaseKey, KeyMistake> find_key(std::string_view path, Case const& c) {
  std::string_view const first = path.substr(0, path.find('.'));
  bool const inside = first.size() < path.size();
  for (SectionInfo const& section : section_table) {
    if (section.section == Section::top || first != section.key) continue;
    if (!inside)
      return KeyMistake{"is a table",
                        fmt::format("name a key in it: \"{}.NAME.KEY\"", section.key)};
    switch (section.section) {
      case Section::material:
        return key_of_item(path, section.section, material_entries(), c.materials);
      case Section::region:
        return key_of_item(path, section.section, region_entries(), c.regions);
      case Section::wall:
        return key_of_item(path, section.section, wall_entries(), c.walls);
      case Section::gauge:
        return key_of_item(path, section.section, gauge_entries(), c.gauges);
      case Section::stage:
        return key_of_item(path, section.section, stage_entries(), c.stages);
      case Section::reference:
        return key_of_item(path, section.section, reference_entries(), c.references);
      case Section::top:
        break;
    }
  }
  return key_in(path, Section::top, "", path, case_entries(), c);
}

}  // namespace moraine
