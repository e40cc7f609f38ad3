#include "walls/dummy_layer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace moraine {
namespace {

// A lattice coordinate and how far it is behind the planes of the minus and the plus side; negative
// in front of them.
struct AxisPoint {
  double x;
  std::array<double, 2> behind;
};

using Lattice = std::array<std::vector<AxisPoint>, 3>;

// What the depths of a lattice point behind the sides say about it.
struct Nearest {
  std::size_t side = 0;
  double depth = 0.0;
  bool unique = false;  // one side alone is nearest, and the foot of the perpendicular is on it
};

// The nearest whole number from 1, halves down: k + 1/2 stays below the ratio for all k < number.
std::size_t whole_number(double ratio) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(ratio - 0.5 - 1e-9)));
}

std::vector<AxisPoint> even_lattice(double low, double high, double margin, std::size_t count) {
  double const length = high - low;
  double const step = count > 1 ? (length - 2.0 * margin) / static_cast<double>(count - 1) : 0.0;
  std::vector<AxisPoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    double const offset = count > 1 ? margin + static_cast<double>(k) * step : 0.5 * length;
    points.push_back({low + offset, {offset, length - offset}});
  }
  return points;
}

std::vector<AxisPoint> tank_lattice(BoxWall const& wall, std::size_t axis, double spacing,
                                    int layers) {
  double const low = wall.min[axis];
  double const high = wall.max[axis];
  std::vector<AxisPoint> points;
  auto const depth = [spacing](int layer) { return (layer + 0.5) * spacing; };
  if (!wall.open[axis][0])
    for (int layer = layers - 1; layer >= 0; --layer)
      points.push_back({low - depth(layer), {depth(layer), low - high - depth(layer)}});
  auto const count = static_cast<int>(whole_number((high - low) / spacing));
  for (int k = 0; k < count; ++k)
    points.push_back({low + depth(k), {-depth(k), low - high + depth(k)}});
  if (!wall.open[axis][1])
    for (int layer = 0; layer < layers; ++layer)
      points.push_back({high + depth(layer), {low - high - depth(layer), depth(layer)}});
  return points;
}

std::vector<AxisPoint> axis_lattice(BoxWall const& wall, std::size_t axis, double spacing,
                                    int layers) {
  if (axis >= static_cast<std::size_t>(wall.dimension)) return {{0.0, {}}};
  auto const box = covered_box(wall);
  std::size_t const count = whole_number((box[1][axis] - box[0][axis]) / spacing);
  if (spans_period(wall, axis)) {
    double const step = (box[1][axis] - box[0][axis]) / static_cast<double>(count);
    return even_lattice(box[0][axis], box[1][axis], 0.5 * step, count);
  }
  if (wall.max[axis] - wall.min[axis] < spacing * (1.0 - 1e-9))
    throw std::invalid_argument(std::string("box wall: on axis ") + "xyz"[axis] +
                                " the box is thinner than the particle spacing");
  if (wall.solid == SolidSide::outside) return tank_lattice(wall, axis, spacing, layers);
  return even_lattice(wall.min[axis], wall.max[axis], 0.5 * spacing, count);
}

// Solid outside: behind the side with the greatest depth, and at an edge if behind two.
std::optional<Nearest> nearest_outside(std::vector<double> const& depths) {
  auto const deepest = std::max_element(depths.begin(), depths.end());
  if (!(*deepest > 0.0)) return std::nullopt;
  auto const behind = std::count_if(depths.begin(), depths.end(), [](double d) { return d > 0.0; });
  return Nearest{static_cast<std::size_t>(deepest - depths.begin()), *deepest, behind == 1};
}

// Solid inside: the nearest of all sides, none where that is deeper than the layers reach.
std::optional<Nearest> nearest_inside(std::vector<double> const& depths, double spacing,
                                      int layers) {
  auto const least = std::min_element(depths.begin(), depths.end());
  if (!(*least < layers * spacing)) return std::nullopt;
  double const tie = *least + 1e-9 * spacing;
  auto const near =
      std::count_if(depths.begin(), depths.end(), [tie](double d) { return d <= tie; });
  return Nearest{static_cast<std::size_t>(least - depths.begin()), *least, near == 1};
}

class LayerBuilder {
 public:
  LayerBuilder(BoxWall const& wall, double spacing, int layers, std::uint32_t surface)
      : wall_(wall),
        sides_(closed_sides(wall)),
        spacing_(spacing),
        layers_(layers),
        surface_(surface),
        depths_(sides_.size()) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      lattice_[axis] = axis_lattice(wall, axis, spacing, layers);
  }

  std::vector<Dummy> build() {
    for (AxisPoint const& z : lattice_[2])
      for (AxisPoint const& y : lattice_[1])
        for (AxisPoint const& x : lattice_[0]) visit({&x, &y, &z});
    return std::move(dummies_);
  }

 private:
  void visit(std::array<AxisPoint const*, 3> const& point) {
    for (std::size_t s = 0; s < sides_.size(); ++s)
      depths_[s] = point[sides_[s].axis]->behind[sides_[s].end];
    auto const nearest = wall_.solid == SolidSide::outside
                             ? nearest_outside(depths_)
                             : nearest_inside(depths_, spacing_, layers_);
    if (nearest) add_dummy({point[0]->x, point[1]->x, point[2]->x}, *nearest);
  }

  void add_dummy(Vec3 const& position, Nearest const& nearest) {
    BoxSide const& side = sides_[nearest.side];
    FacePlace const place = place_on_side(wall_, nearest.side, position);
    Vec3 normal{};
    if (nearest.unique) normal[side.axis] = side.fluid_sign;
    dummies_.push_back({position, normal, surface_, place.face, place.uv, nearest.depth});
  }

  BoxWall const& wall_;
  std::vector<BoxSide> sides_;
  double spacing_;
  int layers_;
  std::uint32_t surface_;
  Lattice lattice_;
  std::vector<double> depths_;  // behind each side, of the point being visited
  std::vector<Dummy> dummies_;
};

}  // namespace

std::vector<Dummy> make_dummy_layer(BoxWall const& wall, double spacing, int layers,
                                    std::uint32_t surface) {
  check(wall);
  if (!(spacing > 0.0)) throw std::invalid_argument("box wall: the spacing must be positive");
  if (layers < 1) throw std::invalid_argument("box wall: there must be at least one layer");
  return LayerBuilder(wall, spacing, layers, surface).build();
}

}  // namespace moraine
