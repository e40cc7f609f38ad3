#include "output/free_surface/contour.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <unordered_map>
#include <utility>

namespace moraine {
namespace {

/// Corners of a simplex: nodes of the grid, and whether their order is a right-handed one.
struct Simplex {
  std::array<std::size_t, 4> node;
  bool positive;
};

class Marching {
 public:
  Marching(NodeGrid const& grid, double level) : grid_(grid), level_(level) {}

  Contour run() {
    bool const solid = grid_.nodes[2] > 1;
    contour_.corners = solid ? 3 : 2;
    for (std::size_t k = 0; k + 1 < std::max<std::size_t>(grid_.nodes[2], 2); ++k)
      for (std::size_t j = 0; j + 1 < grid_.nodes[1]; ++j)
        for (std::size_t i = 0; i + 1 < grid_.nodes[0]; ++i) {
          std::size_t const corner = grid_.index(i, j, k);
          if (solid)
            cross_cube(corner);
          else
            cross_square(corner);
        }
    return std::move(contour_);
  }

 private:
  bool inside(std::size_t node) const { return grid_.value[node] >= level_; }

  /// Whether all corners of a cell lie on one side.
  bool is_plain(std::size_t corner, std::size_t up) const {
    std::size_t const row = grid_.nodes[0];
    bool const first = inside(corner);
    for (std::size_t const base : {corner, corner + up})
      for (std::size_t const node : {base, base + 1, base + row, base + row + 1})
        if (inside(node) != first) return false;
    return true;
  }

  void cross_cube(std::size_t corner) {
    std::array const step{std::size_t{1}, grid_.nodes[0], grid_.nodes[0] * grid_.nodes[1]};
    if (is_plain(corner, step[2])) return;
    constexpr std::array<std::array<std::size_t, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (std::size_t k = 0; k < orders.size(); ++k) {
      auto const& [a, b, c] = orders[k];
      std::size_t const first = corner + step[a];
      std::size_t const second = first + step[b];
      cross_tetrahedron({{corner, first, second, second + step[c]}, k < 3});
    }
  }

  void cross_square(std::size_t corner) {
    if (is_plain(corner, 0)) return;
    std::size_t const row = grid_.nodes[0];
    cross_triangle({{corner, corner + 1, corner + 1 + row, 0}, true});
    cross_triangle({{corner, corner + row, corner + 1 + row, 0}, false});
  }

  /// Puts the inner corners first; returns how many they are.
  std::size_t sort(Simplex& simplex, std::size_t corners) const {
    std::size_t count = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      if (!inside(simplex.node[k])) continue;
      if (k != count) {
        std::swap(simplex.node[k], simplex.node[count]);
        simplex.positive = !simplex.positive;
      }
      ++count;
    }
    return count;
  }

  void cross_tetrahedron(Simplex s) {
    std::size_t const count = sort(s, 4);
    if (count == 0 || count == 4) return;
    auto const at = [&](std::size_t a, std::size_t b) { return point(s.node[a], s.node[b]); };
    if (count == 1) return add({at(0, 1), at(0, 2), at(0, 3)}, s.positive);
    if (count == 3) return add({at(3, 0), at(3, 1), at(3, 2)}, s.positive);
    add({at(0, 2), at(0, 3), at(1, 3)}, s.positive);
    add({at(0, 2), at(1, 3), at(1, 2)}, s.positive);
  }

  void cross_triangle(Simplex s) {
    std::size_t const count = sort(s, 3);
    if (count == 0 || count == 3) return;
    auto const at = [&](std::size_t a, std::size_t b) { return point(s.node[a], s.node[b]); };
    if (count == 1)
      add({at(0, 1), at(0, 2)}, s.positive);
    else
      add({at(1, 2), at(0, 2)}, s.positive);
  }

  void add(std::initializer_list<std::uint32_t> cell, bool positive) {
    contour_.cells.insert(contour_.cells.end(), cell);
    if (!positive) std::swap(contour_.cells.back(), *(contour_.cells.end() - 2));
  }

  /// The point between two nodes of different sides; made where it is new.
  std::uint32_t point(std::size_t a, std::size_t b) {
    if (a > b) std::swap(a, b);
    // An edge leads from its lower node by 0 or 1 along each axis: eight directions.
    std::array const low = grid_.of(a);
    std::array const high = grid_.of(b);
    std::uint64_t const direction =
        (high[0] - low[0]) + 2 * (high[1] - low[1]) + 4 * (high[2] - low[2]);
    auto const [found, is_new] =
        known_.try_emplace(8 * a + direction, static_cast<std::uint32_t>(contour_.points.size()));
    if (!is_new) return found->second;
    double const from = grid_.value[a];
    double const share = (level_ - from) / (grid_.value[b] - from);
    contour_.points.push_back(
        moraine::add(scale(1.0 - share, grid_.place(a)), scale(share, grid_.place(b))));
    Vec3 const slope =
        moraine::add(scale(1.0 - share, grid_.gradient(a)), scale(share, grid_.gradient(b)));
    double const steepness = norm(slope);
    contour_.normals.push_back(steepness > 0.0 ? scale(-1.0 / steepness, slope) : Vec3{});
    return found->second;
  }

  NodeGrid const& grid_;
  double level_;
  Contour contour_;
  std::unordered_map<std::uint64_t, std::uint32_t> known_;
};

}  // namespace

Contour contour_at(NodeGrid const& grid, double level) { return Marching(grid, level).run(); }

double size_of(Contour const& contour) {
  double sum = 0.0;
  for (std::size_t k = 0; k < contour.cells.size(); k += contour.corners) {
    Vec3 const& a = contour.points[contour.cells[k]];
    Vec3 const ab = subtract(contour.points[contour.cells[k + 1]], a);
    if (contour.corners == 2)
      sum += norm(ab);
    else
      sum += 0.5 * norm(cross(ab, subtract(contour.points[contour.cells[k + 2]], a)));
  }
  return sum;
}

double content_of(Contour const& contour) {
  double sum = 0.0;
  for (std::size_t k = 0; k < contour.cells.size(); k += contour.corners) {
    Vec3 const& a = contour.points[contour.cells[k]];
    Vec3 const& b = contour.points[contour.cells[k + 1]];
    if (contour.corners == 2)
      sum += 0.5 * cross(a, b)[2];
    else
      sum += dot(a, cross(b, contour.points[contour.cells[k + 2]])) / 6.0;
  }
  return sum;
}

}  // namespace moraine
