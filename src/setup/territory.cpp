#include "setup/territory.hpp"

#include <algorithm>
#include <limits>

#include "base/input_error.hpp"
#include "setup/geometry.hpp"

namespace moraine {
namespace {

constexpr double face_tolerance = 1e-6;  // spacings

Box without_open_sides(WallSpec const& wall) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box = wall.box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (wall.open[axis][0]) box.min[axis] = -infinity;
    if (wall.open[axis][1]) box.max[axis] = infinity;
  }
  return box;
}

}  // namespace

Territory::Territory(Case const& c)
    : case_(c), tolerance_(face_tolerance * c.numerics.spacing), upward_(upward_of(c)) {
  for (auto const& wall : c.walls)
    (wall.form == WallForm::container ? containers_ : solids_)
        .push_back(wall.form == WallForm::container ? without_open_sides(wall) : wall.box);
  for (auto const& region : c.regions) {
    materials_.push_back(materials_of(region));
    bool const layered = !region.layers.materials.empty();
    tops_.push_back(layered ? top_of_layers(region, c, *upward_) : 0.0);
  }
}

std::vector<MaterialId> Territory::materials_of(RegionSpec const& region) const {
  auto names = region.layers.materials;
  if (names.empty()) names.push_back(region.material);
  std::vector<MaterialId> ids;
  for (auto const& name : names) {
    auto const found = std::find_if(case_.materials.begin(), case_.materials.end(),
                                    [&](auto const& material) { return material.name == name; });
    if (found == case_.materials.end())
      throw InputErrors({problem_of(case_, "region." + region.name + ".material",
                                    "is not a material of this case")});
    ids.push_back(static_cast<MaterialId>(found - case_.materials.begin()));
  }
  return ids;
}

std::optional<MaterialId> Territory::material(std::size_t i, Point const& point) const {
  RegionSpec const& region = case_.regions[i];
  if (!contains_tree(region, point, case_.dimension, tolerance_)) return std::nullopt;
  if (region.layers.materials.empty()) return materials_[i].front();
  auto const layer =
      layer_at(region.layers, tops_[i], upward_->height(point), upward_->sign, tolerance_);
  return layer ? std::optional(materials_[i][*layer]) : std::nullopt;
}

std::optional<Territory::Owner> Territory::owner(Point const& point) const {
  for (std::size_t i = case_.regions.size(); i-- > 0;)
    if (auto const found = material(i, point)) {
      if (!may_be_filled(point)) return std::nullopt;
      return Owner{i, *found};
    }
  return std::nullopt;
}

Box Territory::range() const {
  auto const regions = box_around_regions(case_);
  return regions ? common(case_.domain, *regions) : case_.domain;
}

bool Territory::in_any(std::vector<Box> const& boxes, Point const& point) const {
  return std::any_of(boxes.begin(), boxes.end(), [&](Box const& box) {
    return contains(box, point, case_.dimension, tolerance_);
  });
}

bool Territory::may_be_filled(Point const& point) const {
  if (!contains(case_.domain, point, case_.dimension, tolerance_)) return false;
  if (!containers_.empty() && !in_any(containers_, point)) return false;
  return !in_any(solids_, point);
}

}  // namespace moraine
