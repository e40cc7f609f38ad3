#include "setup/shape_table.hpp"

#include <fmt/core.h>

#include <string_view>
#include <utility>

#include "setup/case.hpp"
#include "setup/table_reader.hpp"
#include "setup/value_reader.hpp"

namespace moraine {
namespace {

template <class Target>
class ShapeTable {
 public:
  ShapeTable(std::vector<Entry<Target>>& table, Section section)
      : table_(table), section_(section) {}

  void choice() {
    table_.push_back(alternative<Target, &Target::shape>(
        {.section = section_,
         .key = "shape",
         .type = ValueType::shape_key,
         .presence = Presence::required,
         .names = {"box", "disc", "half_plane", "cylinder", "polygon", "stl"},
         .meaning = "the shape that is filled"}));
  }

  /// A key of one shape; returns its entry to be refined.
  template <class Form, auto Member>
  Entry<Target>& add(std::string_view shape, Parameter parameter) {
    parameter.section = section_;
    parameter.when_key = "shape";
    parameter.when_value = shape;
    table_.push_back(member_of<Target, &Target::shape, Form, Member>(std::move(parameter)));
    return table_.back();
  }

  void list(std::string_view key, std::string_view meaning) {
    table_.push_back({{.section = section_,
                       .key = key,
                       .type = ValueType::shapes,
                       .preset_note = "none",
                       .meaning = meaning},
                      [](Target&, Value const&) {},
                      [](Target const&) { return Value(); }});
  }

 private:
  std::vector<Entry<Target>>& table_;
  Section section_;
};

Parameter place(std::string_view key, std::string_view meaning) {
  return {.key = key,
          .type = ValueType::vector,
          .quantity = Quantity::length,
          .presence = Presence::required,
          .meaning = meaning};
}

Parameter radius(std::string_view key, std::string_view meaning) {
  return {.key = key,
          .quantity = Quantity::length,
          .presence = Presence::required,
          .limits = Limits::positive(),
          .meaning = meaning};
}

template <class Target>
void add_round_shapes(ShapeTable<Target>& table) {
  table.template add<Disc, &Disc::center>(
      "disc", place("disc.center", "centre of the disc, of the ball in 3D"));
  table.template add<Disc, &Disc::radius>("disc", radius("disc.radius", "radius"));
  table.template add<Cylinder, &Cylinder::start>(
      "cylinder", place("cylinder.start", "middle of one end; the axis may have any direction"));
  table.template add<Cylinder, &Cylinder::end>("cylinder",
                                               place("cylinder.end", "middle of the other end"));
  table.template add<Cylinder, &Cylinder::radius>(
      "cylinder", radius("cylinder.radius", "radius; in 2D half the width of the strip"));
}

template <class Target>
void add_half_plane(ShapeTable<Target>& table) {
  table.template add<HalfPlane, &HalfPlane::point>(
      "half_plane", place("half_plane.point", "a point of the bounding plane"));
  Parameter normal =
      place("half_plane.normal", "normal of the plane out of the filled side, of any length");
  normal.quantity = Quantity::number;
  table.template add<HalfPlane, &HalfPlane::normal>("half_plane", std::move(normal));
}

template <class Target>
void add_polygon(ShapeTable<Target>& table) {
  table.template add<Polygon, &Polygon::corners>(
      "polygon", {.key = "polygon.corners",
                  .type = ValueType::corners,
                  .quantity = Quantity::length,
                  .presence = Presence::required,
                  .meaning = "corners in order, [[x, y], ...]; in 3D those across the axis"});
  auto& axis = table.template add<Polygon, &Polygon::axis>(
      "polygon", {.key = "polygon.axis",
                  .type = ValueType::choice,
                  .preset_note = "z",
                  .names = {axis_names.begin(), axis_names.end()},
                  .meaning = "3D: axis of the prism; its corners are (y, z) for x, (x, z) for y"});
  axis.get = [](Target const& target) {
    auto const* polygon = std::get_if<Polygon>(&target.shape);
    return polygon != nullptr && polygon->from ? Value(polygon->axis) : Value();
  };
  Parameter end{.key = "polygon.from",
                .quantity = Quantity::length,
                .preset_note = "needed in 3D",
                .meaning = "3D: lower end of the prism along its axis"};
  table.template add<Polygon, &Polygon::from>("polygon", end);
  end.key = "polygon.to";
  end.meaning = "3D: upper end of the prism along its axis";
  table.template add<Polygon, &Polygon::to>("polygon", end);
}

template <class Target>
void add_stl(ShapeTable<Target>& table) {
  table.template add<StlBody, &StlBody::file>(
      "stl", {.key = "stl.file",
              .type = ValueType::text,
              .presence = Presence::required,
              .meaning = "STL file, text or binary; its path counts from the case file"});
  table.template add<StlBody, &StlBody::units>(
      "stl", {.key = "stl.units",
              .type = ValueType::text,
              .presence = Presence::required,
              .meaning = "length unit of the numbers in the file, such as \"mm\""});
  table.template add<StlBody, &StlBody::shift>("stl",
                                               {.key = "stl.shift",
                                                .type = ValueType::vector,
                                                .quantity = Quantity::length,
                                                .preset = Point{},
                                                .meaning = "added to all places of the file"});
  table.template add<StlBody, &StlBody::defects>(
      "stl", {.key = "stl.defects",
              .type = ValueType::choice,
              .preset = static_cast<int>(StlDefects::refuse),
              .names = {"refuse", "accept"},
              .meaning = "what happens if the triangles leave holes or overlap; accept: the "
                         "winding number closes them"});
}

template <class Target>
std::string item_text(Target const& item, int dimension) {
  std::string text;
  for (auto const& [parameter, set, get] : shape_entries()) {
    if (parameter.type == ValueType::shape_key) continue;
    std::string const value = to_toml(get(item), parameter, dimension);
    if (!value.empty())
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", parameter.key, value);
  }
  return text;
}

std::string list_text(std::vector<ShapeTree> const& items, int dimension) {
  std::string text;
  for (ShapeTree const& item : items) {
    std::string inner = item_text(item, dimension);
    if (!item.plus.empty()) inner += ", plus = " + list_text(item.plus, dimension);
    if (!item.minus.empty()) inner += ", minus = " + list_text(item.minus, dimension);
    text += fmt::format("{}{{ {} }}", text.empty() ? "" : ", ", inner);
  }
  return "[" + text + "]";
}

void read_list(toml::table const& table, std::string_view key, std::string const& prefix,
               std::vector<ShapeTree>& items, int const& dimension, Source& source) {
  auto const* node = table.get(key);
  auto const* list = node != nullptr ? node->as_array() : nullptr;
  if (list == nullptr) return;
  for (auto const& item : *list) {
    std::string const full = fmt::format("{}{}[{}]", prefix, key, items.size() + 1);
    ShapeTree& tree = items.emplace_back();
    source.remember(full, stretch_of(item.source()));
    auto const* inner = item.as_table();
    if (inner == nullptr) {
      source.report_value(full, "is no shape", "write { disc = { ... } }");
      continue;
    }
    read_table(TableReader(*inner, full + '.', source), shape_entries(), tree, dimension);
    read_shape_lists(*inner, full + '.', tree, dimension, source);
  }
}

}  // namespace

template <class Target>
void add_shape_entries(std::vector<Entry<Target>>& entries, Section section) {
  ShapeTable<Target> table(entries, section);
  table.choice();
  table.template add<Box, &Box::min>("box", place("box.min", "lower corner"));
  table.template add<Box, &Box::max>("box", place("box.max", "upper corner"));
  add_round_shapes(table);
  add_half_plane(table);
  add_polygon(table);
  add_stl(table);
  table.list("plus", "shapes that are filled too: [{ disc = { ... } }, ...]");
  table.list("minus", "shapes that are left out, from plus too");
}

template <class Target>
void read_shape_lists(toml::table const& table, std::string const& prefix, Target& target,
                      int const& dimension, Source& source) {
  read_list(table, "plus", prefix, target.plus, dimension, source);
  read_list(table, "minus", prefix, target.minus, dimension, source);
}

template <class Target>
std::string shape_lists_text(Target const& target, int dimension) {
  std::string text;
  if (!target.plus.empty()) text += "plus = " + list_text(target.plus, dimension) + "\n";
  if (!target.minus.empty()) text += "minus = " + list_text(target.minus, dimension) + "\n";
  return text;
}

std::span<Entry<ShapeTree> const> shape_entries() {
  static std::vector<Entry<ShapeTree>> const table = [] {
    std::vector<Entry<ShapeTree>> entries;
    add_shape_entries(entries, Section::region);
    return entries;
  }();
  return table;
}

template void add_shape_entries(std::vector<Entry<RegionSpec>>&, Section);
template void read_shape_lists(toml::table const&, std::string const&, RegionSpec&, int const&,
                               Source&);
template std::string shape_lists_text(RegionSpec const&, int);

}  // namespace moraine
