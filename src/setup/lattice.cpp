#include "setup/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace moraine {
namespace {

// The box that the lattice is anchored at and fitted to.
std::optional<Box> anchor_box(Case const& c) {
  for (auto const& wall : c.walls)
    if (wall.form == WallForm::container) return wall.box;
  for (auto const& region : c.regions)
    if (auto const* box = std::get_if<Box>(&region.shape)) return *box;
  return std::nullopt;
}

// Half an edge of the cell before it is fitted: the distance of its layers.
Point hexagonal_layers(int dimension, double spacing) {
  if (dimension == 3) {
    double const half = 0.5 * std::cbrt(4.0) * spacing;
    return {half, half, half};
  }
  double const a = std::sqrt(2.0 / std::sqrt(3.0)) * spacing;
  return {0.5 * a, 0.5 * std::sqrt(3.0) * a, 0.0};
}

// The next distance that divides the length into a whole number of layers, or of pairs.
double fitted(double layer, double length, bool pairs) {
  double const unit = pairs ? 2.0 * layer : layer;
  return layer * (length / unit) / std::max(1.0, std::round(length / unit));
}

Lattice square(Case const& c, double spacing) {
  Lattice lattice;
  lattice.basis.emplace_back();
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    lattice.edge[axis] = spacing;
    lattice.basis.front()[axis] = 0.5;
  }
  lattice.volume = std::pow(spacing, c.dimension);
  return lattice;
}

Lattice hexagonal(Case const& c, double spacing) {
  Lattice lattice;
  Point const layer = hexagonal_layers(c.dimension, spacing);
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    lattice.edge[axis] = 2.0 * layer[axis];
  if (c.dimension == 2)
    lattice.basis = {{0.25, 0.25, 0.0}, {0.75, 0.75, 0.0}};
  else
    lattice.basis = {
        {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
  lattice.volume = std::pow(spacing, c.dimension);
  return lattice;
}

bool is_hexagonal(Case const& c) { return c.lattice == LatticeName::hexagonal && c.dimension > 1; }

}  // namespace

Point lattice_anchor(Case const& c) {
  auto const box = anchor_box(c);
  return box ? box->min : Point{};
}

Lattice plain_lattice(Case const& c, double spacing) {
  Lattice lattice = is_hexagonal(c) ? hexagonal(c, spacing) : square(c, spacing);
  lattice.spacing = spacing;
  return lattice;
}

void fit_lattice(Lattice& lattice, std::size_t axis, double length, bool pairs) {
  lattice.edge[axis] = 2.0 * fitted(0.5 * lattice.edge[axis], length, pairs);
  lattice.volume = 2.0;  // every second crossing of the layers holds a point
  for (double const edge : lattice.edge)
    if (edge > 0.0) lattice.volume *= 0.5 * edge;
}

Lattice make_lattice(Case const& c) {
  Lattice lattice = plain_lattice(c, c.numerics.spacing);
  lattice.origin = lattice_anchor(c);
  auto const box = anchor_box(c);
  for (std::size_t axis = 0; is_hexagonal(c) && axis < static_cast<std::size_t>(c.dimension);
       ++axis) {
    // Along x a row takes two layers, so that all rows have the same number of points.
    bool const pairs = axis == 0 || c.periodic[axis];
    if (c.periodic[axis])
      fit_lattice(lattice, axis, c.domain.max[axis] - c.domain.min[axis], pairs);
    else if (box)
      fit_lattice(lattice, axis, box->max[axis] - box->min[axis], pairs);
  }
  return lattice;
}

}  // namespace moraine
