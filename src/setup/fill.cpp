#include "setup/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/input_error.hpp"
#include "setup/geometry.hpp"
#include "setup/hydrostatic_layers.hpp"
#include "setup/initial_state.hpp"

namespace moraine {
namespace {

constexpr double face_tolerance = 1e-6;  // spacings

Box common(Box a, Box const& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    a.min[axis] = std::max(a.min[axis], b.min[axis]);
    a.max[axis] = std::min(a.max[axis], b.max[axis]);
  }
  return a;
}

// The box that holds all particles.
Box filled_range(Case const& c) {
  auto const regions = box_around_regions(c);
  return regions ? common(c.domain, *regions) : c.domain;
}

Box without_open_sides(WallSpec const& wall) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box = wall.box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (wall.open[axis][0]) box.min[axis] = -infinity;
    if (wall.open[axis][1]) box.max[axis] = infinity;
  }
  return box;
}

class Filler {
 public:
  explicit Filler(Case const& c)
      : case_(c),
        spacing_(c.numerics.spacing),
        tolerance_(face_tolerance * spacing_),
        volume_(std::pow(spacing_, c.dimension)),
        anchor_(lattice_anchor(c)),
        vertical_(vertical_of(c.gravity)),
        counts_(c.regions.size(), 0),
        stateless_(c.regions.size(), false) {
    for (auto const& wall : c.walls)
      (wall.form == WallForm::container ? containers_ : solids_)
          .push_back(wall.form == WallForm::container ? without_open_sides(wall) : wall.box);
    for (auto const& region : c.regions) materials_.push_back(material_of(region));
  }

  std::vector<Seed> fill() {
    Box const range = filled_range(case_);
    std::array<std::int64_t, 3> first{}, last{};  // inclusive; one layer in unused dimensions
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis) {
      first[axis] = std::llround(std::floor((range.min[axis] - anchor_[axis]) / spacing_)) - 1;
      last[axis] = std::llround(std::ceil((range.max[axis] - anchor_[axis]) / spacing_));
    }
    for (auto z = first[2]; z <= last[2]; ++z)
      for (auto y = first[1]; y <= last[1]; ++y)
        for (auto x = first[0]; x <= last[0]; ++x) visit(lattice_point({x, y, z}));
    throw_problems();
    if (!layered_.empty()) compress_layers(seeds_, layered_, case_, *vertical_);
    return std::move(seeds_);
  }

  double estimate() const {
    double volume = 0.0;
    for (std::size_t i = 0; i < case_.regions.size(); ++i) volume += sampled_volume(i);
    return volume / volume_;
  }

 private:
  // Of the part of region i that gets particles, from samples in the middle of equal cells.
  double sampled_volume(std::size_t i) const {
    constexpr std::array samples{4096, 128, 40};  // along each axis, by dimension
    auto const bounded = bounding_box(case_.regions[i].shape, case_.dimension);
    Box const box = bounded ? common(case_.domain, *bounded) : case_.domain;
    int const along = samples[static_cast<std::size_t>(case_.dimension - 1)];
    std::array<int, 3> count{1, 1, 1};
    double cell = 1.0;  // m^dimension
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis) {
      count[axis] = along;
      cell *= std::max(box.max[axis] - box.min[axis], 0.0) / along;
    }
    std::size_t filled = 0;
    for (int z = 0; z < count[2]; ++z)
      for (int y = 0; y < count[1]; ++y)
        for (int x = 0; x < count[0]; ++x) {
          Point point{};
          for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
            point[axis] = box.min[axis] + (std::array{x, y, z}[axis] + 0.5) *
                                              (box.max[axis] - box.min[axis]) / along;
          filled += region_at(point) == i && may_be_filled(point) ? 1 : 0;
        }
    return cell * static_cast<double>(filled);
  }

  // The last region around a point; the number of regions where there is none.
  std::size_t region_at(Point const& point) const {
    for (std::size_t i = case_.regions.size(); i-- > 0;)
      if (contains(case_.regions[i].shape, point, case_.dimension, tolerance_)) return i;
    return case_.regions.size();
  }

  MaterialId material_of(RegionSpec const& region) {
    auto const found =
        std::find_if(case_.materials.begin(), case_.materials.end(),
                     [&](auto const& material) { return material.name == region.material; });
    if (found == case_.materials.end())
      throw InputErrors({problem(region, ".material", "is not a material of this case")});
    return static_cast<MaterialId>(found - case_.materials.begin());
  }

  Point lattice_point(std::array<std::int64_t, 3> const& index) const {
    Point point{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
      point[axis] = anchor_[axis] + (static_cast<double>(index[axis]) + 0.5) * spacing_;
    return point;
  }

  bool in_any(std::vector<Box> const& boxes, Point const& point) const {
    return std::any_of(boxes.begin(), boxes.end(), [&](Box const& box) {
      return contains(box, point, case_.dimension, tolerance_);
    });
  }

  bool may_be_filled(Point const& point) const {
    if (!contains(case_.domain, point, case_.dimension, tolerance_)) return false;
    if (!containers_.empty() && !in_any(containers_, point)) return false;
    return !in_any(solids_, point);
  }

  void visit(Point const& point) {
    std::size_t const i = region_at(point);
    if (i < case_.regions.size() && may_be_filled(point)) add(i, point);
  }

  void add(std::size_t i, Point const& point) {
    auto const& region = case_.regions[i];
    ++counts_[i];
    auto const state =
        initial_state(case_.materials[materials_[i]].eos, region.initial, point, case_.gravity);
    if (!state) {
      stateless_[i] = true;
      return;
    }
    bool const layered = in_layers(i);
    if (layered) layered_.push_back(seeds_.size());
    double const lattice_density =
        layered ? reference_density(case_.materials[materials_[i]].eos) : state->density;
    seeds_.push_back({.position = point,
                      .velocity = region.initial.velocity,
                      .density = state->density,
                      .specific_energy = state->specific_energy,
                      .mass = lattice_density * volume_,
                      .material = materials_[i],
                      .region = i});
  }

  // Equal masses are what the sweep of one liquid asks for, and that is a Tait liquid.
  bool in_layers(std::size_t i) const {
    return vertical_ && case_.regions[i].initial.hydrostatic_level &&
           std::holds_alternative<Tait>(case_.materials[materials_[i]].eos);
  }

  InputProblem problem(RegionSpec const& region, std::string_view key, std::string rule,
                       std::string hint = {}) const {
    return problem_of(case_, fmt::format("region.{}{}", region.name, key), std::move(rule),
                      std::move(hint));
  }

  void throw_problems() const {
    std::vector<InputProblem> problems;
    for (std::size_t i = 0; i < case_.regions.size(); ++i) {
      auto const& region = case_.regions[i];
      if (counts_[i] == 0)
        problems.push_back(
            problem(region, "", fmt::format("fills no particle at a spacing of {} m", spacing_),
                    "it is too small, outside the walls or covered by a later region"));
      else if (stateless_[i])
        problems.push_back(
            problem(region, region.initial.pressure ? ".pressure" : ".hydrostatic_level",
                    fmt::format("asks for a pressure that the material \"{}\" cannot have",
                                region.material)));
    }
    if (!problems.empty()) throw InputErrors(std::move(problems));
  }

  Case const& case_;
  double spacing_;
  double tolerance_;
  double volume_;  // m^dimension
  Point anchor_;
  std::optional<Vertical> vertical_;
  std::vector<Box> containers_;
  std::vector<Box> solids_;
  std::vector<MaterialId> materials_;  // of each region
  std::vector<std::size_t> counts_;    // particles of each region
  std::vector<bool> stateless_;        // regions with a pressure that cannot be
  std::vector<Seed> seeds_;
  std::vector<std::size_t> layered_;  // seeds that lie in hydrostatic layers
};

}  // namespace

Point lattice_anchor(Case const& c) {
  for (auto const& wall : c.walls)
    if (wall.form == WallForm::container) return wall.box.min;
  for (auto const& region : c.regions)
    if (auto const* box = std::get_if<Box>(&region.shape)) return box->min;
  return {};
}

std::vector<Seed> fill_regions(Case const& c) { return Filler(c).fill(); }

double estimated_particles(Case const& c) { return Filler(c).estimate(); }

}  // namespace moraine
