#include "setup/check_region.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "setup/check_shape.hpp"
#include "setup/geometry.hpp"
#include "setup/layers.hpp"

namespace moraine {
namespace {

class RegionCheck {
 public:
  RegionCheck(RegionSpec& region, std::string const& key, Case const& c, Source& source)
      : region_(region), key_(key), case_(c), source_(source) {}

  void run() {
    bool const sound = check_shapes(region_, key_);
    check_materials(sound);
    check_rotation();
    check_velocity_field();
    if (region_.initial.lithostatic_load) check_lithostatic();
  }

 private:
  template <class Tree>
  bool check_shapes(Tree& tree, std::string const& key) {
    bool sound = check_shape(tree.shape, key, case_, source_);
    for (auto const& [list, name] :
         {std::pair(&tree.plus, "plus"), std::pair(&tree.minus, "minus")})
      for (std::size_t i = 0; i < list->size(); ++i)
        sound = check_shapes((*list)[i], fmt::format("{}{}[{}].", key, name, i + 1)) && sound;
    return sound;
  }

  void check_materials(bool sound_shape) {
    std::string const own = key_ + "material";
    bool const layered = source_.has(key_ + "layers.materials");
    if (layered && source_.has(own))
      source_.report_value(own, "is given together with layers.materials", "give one of the two");
    if (!layered && !source_.has(own) && !source_.has(key_ + "layers.thickness"))
      source_.report_key(own, place_of_region(), "is missing: name of a material, or give layers");
    if (!source_.good(key_ + "layers.materials")) return;
    check_layers(sound_shape);
  }

  void check_layers(bool sound_shape) {
    Layers const& layers = region_.layers;
    std::vector<std::string_view> known;
    for (auto const& material : case_.materials) known.push_back(material.name);
    for (auto const& name : layers.materials)
      if (std::find(known.begin(), known.end(), name) == known.end())
        source_.report_value(
            key_ + "layers.materials",
            fmt::format("names \"{}\", which is not a material of this case", name),
            name_hint(name, known));
    std::size_t const n = layers.materials.size(), given = layers.thickness.size();
    if (n == 0) source_.report_value(key_ + "layers.materials", "must not be empty");
    if (source_.good(key_ + "layers.thickness") && n > 0 && given != n && given + 1 != n)
      source_.report_value(key_ + "layers.thickness",
                           fmt::format("has {} entries for {} materials; {} or {} are expected",
                                       given, n, n - 1, n));
    if (!upward_of(case_) && !source_.has_problem("physics.gravity"))
      source_.report_value(key_ + "layers.materials", "needs gravity along one axis",
                           "layers lie across it");
    if (!layers.top && sound_shape && !bounding_box_of_tree(region_, case_.dimension))
      source_.report_key(key_ + "layers.top", place_of_region(),
                         "is missing: the shape has no highest point");
  }

  Stretch place_of_region() const { return source_.place_of(key_.substr(0, key_.size() - 1)); }

  void check_rotation() {
    Rotation& rotation = region_.initial.rotation;
    if (!rotation.rate) return;
    if (case_.dimension == 1) source_.report_value(key_ + "rotation.rate", "is not possible in 1D");
    std::string const axis = key_ + "rotation.axis";
    if (!source_.good(axis)) return;
    if (case_.dimension == 2)
      source_.report_value(axis, "is given in 2D", "leave it out: the axis is z");
    else if (length(rotation.axis) == 0.0)
      source_.report_value(axis, "must not be zero");
  }

  void check_velocity_field() {
    VelocityField& field = region_.initial.velocity_field;
    std::string const key = key_ + "velocity_field";
    if (field.texts.empty() || !source_.good(key)) return;
    if (field.texts.size() != static_cast<std::size_t>(case_.dimension))
      return source_.report_value(key,
                                  fmt::format("has {} formulas; {} are expected, one for each axis",
                                              field.texts.size(), case_.dimension));
    field.formulas.clear();
    for (std::string const& text : field.texts) {
      try {
        field.formulas.emplace_back(text, std::vector<std::string>{"x", "y", "z"});
      } catch (std::invalid_argument const& error) {
        return source_.report_value(
            key,
            fmt::format("holds \"{}\", which is no formula of x, y, z: {}", text, error.what()),
            "formulas have no units: lengths in m, velocities in m/s");
      }
    }
  }

  void check_lithostatic() {
    std::string const key = key_ + "lithostatic_load";
    InitialState const& initial = region_.initial;
    if (initial.pressure || initial.hydrostatic_level)
      source_.report_value(key,
                           fmt::format("is given together with {}",
                                       initial.pressure ? "pressure" : "hydrostatic_level"),
                           "give one of the two");
    if (initial.density)
      source_.report_value(key_ + "density", "is given together with lithostatic_load",
                           "leave it out, it is solved for the pressure");
    if (source_.has_problem("physics.gravity")) return;
    if (length(case_.gravity) == 0.0)
      source_.report_value(key, "needs gravity", "give physics.gravity");
    else if (!upward_of(case_))
      source_.report_value(key, "needs gravity along one axis");
  }

  RegionSpec& region_;
  std::string const& key_;
  Case const& case_;
  Source& source_;
};

void check_reach_of(Shape const& shape, std::string const& key, Case const& c, Source& source) {
  std::string const place = place_key(shape, key);
  if (!source.good(place) || !is_complete(shape, c.dimension)) return;
  auto const box = bounding_box(shape, c.dimension);
  if (box && !is_inside(*box, with_mirror_images(c.domain, c), c.dimension))
    source.report_value(place,
                        fmt::format("puts the {} partly outside the domain", word_for(shape)));
}

template <class Tree>
void check_reach_of_plus(Tree const& tree, std::string const& key, Case const& c, Source& source) {
  for (std::size_t i = 0; i < tree.plus.size(); ++i) {
    std::string const part = fmt::format("{}plus[{}].", key, i + 1);
    check_reach_of(tree.plus[i].shape, part, c, source);
    check_reach_of_plus(tree.plus[i], part, c, source);
  }
}

}  // namespace

void check_geometry(RegionSpec& region, std::string const& key, Case const& c, Source& source) {
  if (c.dimension == 0) return;
  RegionCheck(region, key, c, source).run();
}

void check_reach(RegionSpec const& region, std::string const& key, Case const& c, Source& source) {
  // The two corners of a region's own box have messages of their own.
  if (!std::holds_alternative<Box>(region.shape)) check_reach_of(region.shape, key, c, source);
  check_reach_of_plus(region, key, c, source);
}

}  // namespace moraine
