#include "setup/fill.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/input_error.hpp"
#include "setup/geometry.hpp"
#include "setup/hydrostatic_layers.hpp"
#include "setup/initial_state.hpp"
#include "setup/lattice.hpp"
#include "setup/layers.hpp"
#include "setup/overburden.hpp"
#include "setup/region_lattice.hpp"
#include "setup/territory.hpp"

namespace moraine {
namespace {

class Filler {
 public:
  explicit Filler(Case const& c)
      : case_(c),
        territory_(c),
        lattices_(lattices_of_regions(c)),
        vertical_(vertical_of(c.gravity)),
        counts_(c.regions.size()) {
    for (auto const& region : c.regions)
      if (region.initial.lithostatic_load && !overburden_)
        overburden_.emplace(c, territory_, make_lattice(c), *upward_of(c));
    gather_passes();
  }

  std::vector<Seed> fill() {
    for (Pass& pass : passes_)
      for_each_point(pass, [&](Point const& point) {
        auto const owner = territory_.owner(point);
        if (owner && is_in(pass, owner->region)) add(pass, *owner, point);
      });
    throw_problems();
    for (Pass const& pass : passes_)
      if (!pass.layered.empty())
        compress_layers(seeds_, pass.layered, case_, lattice_of(pass), *vertical_);
    return std::move(seeds_);
  }

  std::vector<RegionCount> count() {
    for (Pass const& pass : passes_)
      for_each_point(pass, [&](Point const& point) {
        auto const owner = territory_.owner(point);
        if (!owner) return;
        for (std::size_t const i : pass.regions) {
          if (i == owner->region) ++counts_[i].particles;
          if (i < owner->region) counts_[i].replaced += territory_.reaches(i, point) ? 1 : 0;
        }
      });
    return std::move(counts_);
  }

  std::vector<double> estimate() const {
    std::vector<double> particles;
    for (std::size_t i = 0; i < case_.regions.size(); ++i)
      particles.push_back(sampled_volume(i) / lattices_[i].volume);
    return particles;
  }

 private:
  // Regions that share a lattice: all without one of their own, or a single one.
  struct Pass {
    std::vector<std::size_t> regions;
    std::vector<std::size_t> layered{};  // seeds that lie in hydrostatic layers
  };

  void gather_passes() {
    Pass shared;
    for (std::size_t i = 0; i < case_.regions.size(); ++i)
      if (!has_own_lattice(case_.regions[i])) shared.regions.push_back(i);
    if (!shared.regions.empty()) passes_.push_back(shared);
    for (std::size_t i = 0; i < case_.regions.size(); ++i)
      if (has_own_lattice(case_.regions[i])) passes_.push_back({{i}});
  }

  Lattice const& lattice_of(Pass const& pass) const { return lattices_[pass.regions.front()]; }

  static bool is_in(Pass const& pass, std::size_t region) {
    return std::find(pass.regions.begin(), pass.regions.end(), region) != pass.regions.end();
  }

  Box range_of(Pass const& pass) const {
    RegionSpec const& region = case_.regions[pass.regions.front()];
    if (!has_own_lattice(region)) return territory_.range();
    auto const box = filled_box(case_, region);
    return box ? *box : case_.domain;
  }

  // In the order z, y, x of the cells of the lattice, x fastest.
  template <class Visit>
  void for_each_point(Pass const& pass, Visit visit) const {
    Lattice const& lattice = lattice_of(pass);
    Box const range = range_of(pass);
    std::array<std::int64_t, 3> first{}, last{};  // inclusive; one layer in unused dimensions
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis) {
      double const edge = lattice.edge[axis], origin = lattice.origin[axis];
      first[axis] = std::llround(std::floor((range.min[axis] - origin) / edge)) - 1;
      last[axis] = std::llround(std::ceil((range.max[axis] - origin) / edge));
    }
    for (auto z = first[2]; z <= last[2]; ++z)
      for (auto y = first[1]; y <= last[1]; ++y)
        for (auto x = first[0]; x <= last[0]; ++x)
          for (Point const& part : lattice.basis) visit(lattice_point(lattice, {x, y, z}, part));
  }

  Point lattice_point(Lattice const& lattice, std::array<std::int64_t, 3> const& cell,
                      Point const& part) const {
    Point point{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
      point[axis] = lattice.origin[axis] +
                    (static_cast<double>(cell[axis]) + part[axis]) * lattice.edge[axis];
    return point;
  }

  // Of the part of region i that gets particles, from samples in the middle of equal cells.
  double sampled_volume(std::size_t i) const {
    constexpr std::array samples{4096, 128, 40};  // along each axis, by dimension
    auto const bounded = bounding_box_of_tree(case_.regions[i], case_.dimension);
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
          auto const owner = territory_.owner(point);
          filled += owner && owner->region == i ? 1 : 0;
        }
    return cell * static_cast<double>(filled);
  }

  void add(Pass& pass, Territory::Owner const& owner, Point const& point) {
    auto const& region = case_.regions[owner.region];
    RegionCount& count = counts_[owner.region];
    ++count.particles;
    InitialState initial = region.initial;
    if (initial.lithostatic_load)
      initial.pressure = *initial.lithostatic_load + overburden_->at(point);
    auto const state =
        initial_state(case_.materials[owner.material].eos, initial, point, case_.gravity);
    if (!state) {
      count.stateless = owner.material;
      return;
    }
    if (in_layers(owner)) pass.layered.push_back(seeds_.size());
    seeds_.push_back({.position = point,
                      .velocity = initial_velocity(initial, point),
                      .density = state->density,
                      .specific_energy = state->specific_energy,
                      .mass = state->density * lattice_of(pass).volume,
                      .material = owner.material,
                      .region = owner.region});
  }

  // Equal masses are what the sweep of one liquid asks for, and that is a Tait liquid; columns of
  // equal layers are what the square lattice has.
  bool in_layers(Territory::Owner const& owner) const {
    return vertical_ && case_.lattice == LatticeName::square &&
           case_.regions[owner.region].initial.hydrostatic_level &&
           std::holds_alternative<Tait>(case_.materials[owner.material].eos);
  }

  InputProblem problem(RegionSpec const& region, std::string_view key, std::string rule,
                       std::string hint = {}) const {
    return problem_of(case_, fmt::format("region.{}{}", region.name, key), std::move(rule),
                      std::move(hint));
  }

  static std::string_view key_of_pressure(InitialState const& initial) {
    if (initial.pressure) return ".pressure";
    return initial.hydrostatic_level ? ".hydrostatic_level" : ".lithostatic_load";
  }

  void throw_problems() const {
    std::vector<InputProblem> problems;
    for (std::size_t i = 0; i < case_.regions.size(); ++i) {
      auto const& region = case_.regions[i];
      if (counts_[i].particles == 0)
        problems.push_back(problem(
            region, "", fmt::format("fills no particle at a spacing of {} m", lattices_[i].spacing),
            "it is too small, outside the walls or covered by a later region"));
      else if (counts_[i].stateless)
        problems.push_back(
            problem(region, key_of_pressure(region.initial),
                    fmt::format("asks for a pressure that the material \"{}\" cannot have",
                                case_.materials[*counts_[i].stateless].name)));
    }
    if (!problems.empty()) throw InputErrors(std::move(problems));
  }

  Case const& case_;
  Territory territory_;
  std::vector<Lattice> lattices_;  // by region
  std::vector<Pass> passes_;
  std::optional<Overburden> overburden_;
  std::optional<Vertical> vertical_;
  std::vector<RegionCount> counts_;
  std::vector<Seed> seeds_;
};

}  // namespace

std::vector<Seed> fill_regions(Case const& c) { return Filler(c).fill(); }

std::vector<RegionCount> count_regions(Case const& c) { return Filler(c).count(); }

std::vector<double> estimated_by_region(Case const& c) { return Filler(c).estimate(); }

double estimated_particles(Case const& c) {
  double sum = 0.0;
  for (double const particles : estimated_by_region(c)) sum += particles;
  return sum;
}

}  // namespace moraine
