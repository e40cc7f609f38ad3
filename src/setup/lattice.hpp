// The lattice that regions are filled on.
#pragma once

#include <vector>

#include "setup/case.hpp"

namespace moraine {

/// Points of a lattice: a cell with its edges along the axes, and the points in it.
///
/// Square: cubes of edge `spacing` with a point in the middle. Hexagonal: in 2D rows of points at
/// distance a, each row shifted by a/2 against the next, rows sqrt(3)/2 a apart; in 3D
/// face-centred cubic. In both a particle has the volume spacing^d, as in the square lattice: then
/// a = sqrt(2/sqrt(3)) spacing = 1.075 spacing (2D) and the nearest distance is 2^(1/6) spacing =
/// 1.122 spacing (3D). In 1D both are the same.
struct Lattice {
  Point origin{};            // m, lower corner of a cell
  Point edge{};              // m, of a cell; 0 beyond the dimension
  std::vector<Point> basis;  // points of a cell in parts of its edges
  double volume = 0.0;       // of a particle: m^d
  double spacing = 0.0;      // m, edge of a cube of that volume; of a fitted lattice as asked for

  /// Distance of layers of points across an axis.
  double layer(std::size_t axis) const { return basis.size() > 1 ? 0.5 * edge[axis] : edge[axis]; }
};

/// Corner of the lattice: the lower corner of the first container wall, or else of the first box
/// region, or else the origin. The domain plays no part, so that enlarging it moves no particle.
Point lattice_anchor(Case const& c);

/// The lattice of a case. A hexagonal one is stretched by less than a layer along each axis, so
/// that a whole number of layers fits into the box that gives the corner, and into the period of a
/// periodic axis: the box then holds exactly its mass.
Lattice make_lattice(Case const& c);

/// A lattice of the kind of the case as it is before it is fitted to anything, its corner at the
/// origin. spacing in m.
Lattice plain_lattice(Case const& c, double spacing);

/// Stretches a hexagonal lattice along an axis by less than a layer, so that a length [m] takes a
/// whole number of layers; of pairs of them where rows must repeat themselves.
void fit_lattice(Lattice& lattice, std::size_t axis, double length, bool pairs);

}  // namespace moraine
