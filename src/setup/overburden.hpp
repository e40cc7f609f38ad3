// The weight of what lies above a place at the start.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "setup/lattice.hpp"
#include "setup/layers.hpp"
#include "setup/territory.hpp"

namespace moraine {

/// Vertical total stress [Pa] from the weight of all regions above a place,
///
///   p(z) = integral from z to the top of rho |g| dz',
///
/// rho the initial density of a region where it is given, else the reference density of the
/// material. The column is divided into the layers of the lattice, each of the material in its
/// middle: exact where faces lie between layers, else to half a layer for each face. Where a region
/// has a lattice of its own, layers are divided into eight. Without a strength model this pressure
/// acts to all sides.
class Overburden {
 public:
  /// The case and the territory must outlive the overburden; the lattice is that of the case.
  Overburden(Case const& c, Territory const& territory, Lattice const& lattice, Upward upward);

  /// The pressure at a place; columns are kept, so that the next place in it costs nothing.
  double at(Point const& point);

 private:
  /// Weight above the lower face of each layer of a column [Pa], the lowest layer first.
  std::vector<double> column(Point const& point) const;
  double height_of_face(std::size_t k) const;

  Case const& case_;
  Territory const& territory_;
  Upward upward_;
  double gravity_;  // m/s^2
  double layer_;    // m
  double bottom_;   // m, height of the lowest face
  std::size_t count_ = 0;
  std::map<std::array<double, 2>, std::vector<double>> columns_;  // by the other coordinates
};

}  // namespace moraine
