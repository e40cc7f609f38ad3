#include "setup/mesh/winding_number.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace moraine {
namespace {

constexpr std::uint32_t leaf_size = 8;
constexpr double far = 3.0;  // radii

Vec3 middle_of(Triangle const& t) { return scale(1.0 / 3.0, add(t[0], add(t[1], t[2]))); }

double solid_angle(Triangle const& t, Vec3 const& q) {
  Vec3 const a = subtract(t[0], q), b = subtract(t[1], q), c = subtract(t[2], q);
  double const la = norm(a), lb = norm(b), lc = norm(c);
  double const below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  return 2.0 * std::atan2(dot(a, cross(b, c)), below);
}

}  // namespace

WindingNumber::WindingNumber(TriangleMesh mesh) : mesh_(std::move(mesh)) {
  Cluster root;
  root.count = static_cast<std::uint32_t>(mesh_.triangles.size());
  clusters_.push_back(root);
  build(0);
}

void WindingNumber::measure(Cluster& cluster) const {
  double area = 0.0;
  std::uint32_t const end = cluster.first + cluster.count;
  for (std::uint32_t i = cluster.first; i < end; ++i) {
    Triangle const t = mesh_.corners(i);
    Vec3 const vector = area_vector(t);
    cluster.area_vector = add(cluster.area_vector, vector);
    cluster.middle = add(cluster.middle, scale(norm(vector), middle_of(t)));
    area += norm(vector);
  }
  if (area > 0.0) cluster.middle = scale(1.0 / area, cluster.middle);
  for (std::uint32_t i = cluster.first; i < end; ++i)
    for (Vec3 const& corner : mesh_.corners(i))
      cluster.radius = std::max(cluster.radius, norm(subtract(corner, cluster.middle)));
}

// Halves a cluster across the axis along which its triangles spread most.
void WindingNumber::build(std::size_t index) {
  measure(clusters_[index]);
  std::uint32_t const first = clusters_[index].first, count = clusters_[index].count;
  if (count <= leaf_size) return;
  Vec3 low = middle_of(mesh_.corners(first)), high = low;
  for (std::uint32_t i = first; i < first + count; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double const place = middle_of(mesh_.corners(i))[axis];
      low[axis] = std::min(low[axis], place);
      high[axis] = std::max(high[axis], place);
    }
  Vec3 const spread = subtract(high, low);
  auto const axis =
      static_cast<std::size_t>(std::max_element(spread.begin(), spread.end()) - spread.begin());
  auto const begin = mesh_.triangles.begin() + first;
  std::stable_sort(begin, begin + count, [&](auto const& a, auto const& b) {
    auto const place = [&](auto const& t) {
      return mesh_.vertices[t[0]][axis] + mesh_.vertices[t[1]][axis] + mesh_.vertices[t[2]][axis];
    };
    return place(a) < place(b);
  });
  auto const children = static_cast<std::uint32_t>(clusters_.size());
  clusters_[index].children = children;
  Cluster left, right;
  left.first = first;
  left.count = count / 2;
  right.first = first + left.count;
  right.count = count - left.count;
  clusters_.push_back(left);
  clusters_.push_back(right);
  build(children);
  build(children + 1);
}

double WindingNumber::exact(Vec3 const& q) const {
  double angle = 0.0;
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    angle += solid_angle(mesh_.corners(i), q);
  return angle / (4.0 * std::numbers::pi);
}

double WindingNumber::operator()(Vec3 const& q) const { return sum(0, q); }

double WindingNumber::sum(std::size_t index, Vec3 const& q) const {
  Cluster const& cluster = clusters_[index];
  Vec3 const to = subtract(cluster.middle, q);
  double const distance = norm(to);
  if (distance > far * cluster.radius)
    return dot(cluster.area_vector, to) / (4.0 * std::numbers::pi * distance * distance * distance);
  if (cluster.children != 0) return sum(cluster.children, q) + sum(cluster.children + 1, q);
  double angle = 0.0;
  for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i)
    angle += solid_angle(mesh_.corners(i), q);
  return angle / (4.0 * std::numbers::pi);
}

}  // namespace moraine
