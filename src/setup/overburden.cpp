#include "setup/overburden.hpp"

#include <algorithm>
#include <cmath>

#include "setup/geometry.hpp"
#include "setup/region_lattice.hpp"

namespace moraine {
namespace {

// Regions with lattices of their own have faces between the layers of the case's.
double parts_of_layer(Case const& c) {
  return std::any_of(c.regions.begin(), c.regions.end(), has_own_lattice) ? 8.0 : 1.0;
}

}  // namespace

Overburden::Overburden(Case const& c, Territory const& territory, Lattice const& lattice,
                       Upward upward)
    : case_(c),
      territory_(territory),
      upward_(upward),
      gravity_(length(c.gravity)),
      layer_(lattice.layer(upward.axis) / parts_of_layer(c)) {
  Box const range = territory.range();
  double const anchor = upward.height(lattice.origin);
  double const low = upward.height(upward.sign > 0.0 ? range.min : range.max);
  double const high = upward.height(upward.sign > 0.0 ? range.max : range.min);
  double const first = std::floor((low - anchor) / layer_ - 0.5);
  bottom_ = anchor + first * layer_;
  count_ = static_cast<std::size_t>(std::max(0.0, std::ceil((high - bottom_) / layer_ + 0.5)));
}

double Overburden::height_of_face(std::size_t k) const {
  return bottom_ + static_cast<double>(k) * layer_;
}

std::vector<double> Overburden::column(Point const& point) const {
  std::vector<double> weight(count_ + 1, 0.0);
  Point place = point;
  for (std::size_t k = count_; k-- > 0;) {
    place[upward_.axis] = upward_.sign * (height_of_face(k) + 0.5 * layer_);
    double density = 0.0;
    if (auto const owner = territory_.owner(place))
      density = case_.regions[owner->region].initial.density.value_or(
          reference_density(case_.materials[owner->material].eos));
    weight[k] = weight[k + 1] + density * gravity_ * layer_;
  }
  return weight;
}

double Overburden::at(Point const& point) {
  std::array<double, 2> const key{point[(upward_.axis + 1) % 3], point[(upward_.axis + 2) % 3]};
  auto const [found, fresh] = columns_.try_emplace(key);
  if (fresh) found->second = column(point);
  std::vector<double> const& weight = found->second;
  double const place = (upward_.height(point) - bottom_) / layer_;
  auto const k =
      static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, static_cast<double>(count_ - 1)));
  double const above = 1.0 - (place - static_cast<double>(k));  // part of this layer
  return weight[k + 1] + above * (weight[k] - weight[k + 1]);
}

}  // namespace moraine
