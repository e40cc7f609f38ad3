#include "setup/region_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "setup/geometry.hpp"
#include "setup/hydrostatic_layers.hpp"
#include "setup/initial_state.hpp"

namespace moraine {
namespace {

constexpr double face_tolerance = 1e-6;  // layers

std::size_t index_of_region(Case const& c, std::string const& name) {
  auto const found = std::find_if(c.regions.begin(), c.regions.end(),
                                  [&](RegionSpec const& region) { return region.name == name; });
  if (found == c.regions.end())
    throw std::invalid_argument("equal_mass_with names no region: " + name);
  return static_cast<std::size_t>(found - c.regions.begin());
}

// How far the first layer's cells begin behind the lower end of a length.
double centring(double length, double layer) {
  double const count = std::max(1.0, std::round(length / layer));
  double const rest = length - count * layer;
  return std::abs(rest) < face_tolerance * layer ? 0.0 : 0.5 * rest;
}

void place(Lattice& lattice, Case const& c, RegionSpec const& region) {
  lattice.origin = lattice_anchor(c);
  auto const box = filled_box(c, region);
  auto const vertical = vertical_of(c.gravity);
  bool const hexagonal = lattice.basis.size() > 1;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    bool const around = fills_period(c, region, axis);
    if (!box && !around) continue;
    double const low = around ? c.domain.min[axis] : box->min[axis];
    double const high = around ? c.domain.max[axis] : box->max[axis];
    bool const pairs = hexagonal && (axis == 0 || around);
    if (hexagonal && region.spacing) fit_lattice(lattice, axis, high - low, pairs);
    double const layer = pairs ? lattice.edge[axis] : lattice.layer(axis);
    bool const stands = vertical && vertical->axis == axis;
    lattice.origin[axis] = around   ? low
                           : stands ? (vertical->up > 0 ? low : high)
                                    : low + centring(high - low, layer);
  }
}

// `passed`: how many regions have asked for this one's masses.
Lattice lattice_of(Case const& c, std::size_t i, std::size_t passed) {
  RegionSpec const& region = c.regions[i];
  if (!has_own_lattice(region)) return make_lattice(c);
  if (passed > c.regions.size())
    throw std::invalid_argument("equal_mass_with leads back to region " + region.name);
  Lattice lattice;
  if (region.spacing) {
    lattice = plain_lattice(c, *region.spacing);
  } else {
    std::size_t const other = index_of_region(c, region.equal_mass_with);
    double const volume = lattice_of(c, other, passed + 1).volume *
                          start_density(c, c.regions[other]) / start_density(c, region);
    lattice = plain_lattice(c, std::pow(volume, 1.0 / c.dimension));
    lattice.volume = volume;  // to the last bit
  }
  place(lattice, c, region);
  return lattice;
}

}  // namespace

double start_density(Case const& c, RegionSpec const& region) {
  auto const found = std::find_if(c.materials.begin(), c.materials.end(),
                                  [&](auto const& m) { return m.name == region.material; });
  if (found == c.materials.end())
    throw std::invalid_argument("region " + region.name + " is of no single material");
  if (region.initial.hydrostatic_level || region.initial.lithostatic_load)
    return reference_density(found->eos);
  auto const state = initial_state(found->eos, region.initial, {}, c.gravity);
  return state ? state->density : reference_density(found->eos);
}

std::vector<Lattice> lattices_of_regions(Case const& c) {
  std::vector<Lattice> lattices;
  for (std::size_t i = 0; i < c.regions.size(); ++i) lattices.push_back(lattice_of(c, i, 0));
  return lattices;
}

double finest_spacing(Case const& c) {
  double finest = c.numerics.spacing;
  for (Lattice const& lattice : lattices_of_regions(c)) finest = std::min(finest, lattice.spacing);
  return finest;
}

std::optional<Box> filled_box(Case const& c, RegionSpec const& region) {
  auto box = bounding_box_of_tree(region, c.dimension);
  if (!box) return std::nullopt;
  box = common(*box, c.domain);
  auto const container = std::find_if(c.walls.begin(), c.walls.end(), [](WallSpec const& wall) {
    return wall.form == WallForm::container;
  });
  if (container == c.walls.end()) return box;
  for (std::size_t axis = 0; axis < 3; ++axis) {  // an open side bounds nothing
    if (!container->open[axis][0])
      box->min[axis] = std::max(box->min[axis], container->box.min[axis]);
    if (!container->open[axis][1])
      box->max[axis] = std::min(box->max[axis], container->box.max[axis]);
  }
  return box;
}

bool fills_period(Case const& c, RegionSpec const& region, std::size_t axis) {
  if (!c.periodic[axis]) return false;
  auto const box = filled_box(c, region);
  double const slack = 1e-9 * (c.domain.max[axis] - c.domain.min[axis]);
  return !box || (box->min[axis] <= c.domain.min[axis] + slack &&
                  box->max[axis] >= c.domain.max[axis] - slack);
}

}  // namespace moraine
