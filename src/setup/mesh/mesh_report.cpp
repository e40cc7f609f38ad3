#include "setup/mesh/mesh_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace moraine {
namespace {

/// An edge between vertices `low` < `high`, once for every triangle at it.
struct Use {
  std::uint32_t low, high;
  bool ascending;  // the triangle runs from low to high
};

std::vector<Use> sorted_uses(TriangleMesh const& mesh) {
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (auto const& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      auto const a = t[k], b = t[(k + 1) % 3];
      uses.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(uses.begin(), uses.end(), [](Use const& a, Use const& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  return uses;
}

/// Sets of vertices that hang together by bad edges.
class Groups {
 public:
  explicit Groups(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = of(a);
    b = of(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

struct BadEdge {
  std::uint32_t low, high;
  std::size_t MeshDefect::*kind;
};

std::vector<BadEdge> bad_edges(TriangleMesh const& mesh) {
  std::vector<Use> const uses = sorted_uses(mesh);
  std::vector<BadEdge> bad;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    std::size_t ascending = 0;
    for (end = begin; end < uses.size() && uses[end].low == uses[begin].low &&
                      uses[end].high == uses[begin].high;
         ++end)
      ascending += uses[end].ascending ? 1 : 0;
    std::size_t const count = end - begin;
    if (count == 2 && ascending == 1) continue;
    auto const kind = count == 1   ? &MeshDefect::open
                      : count == 2 ? &MeshDefect::turned
                                   : &MeshDefect::overlapping;
    bad.push_back({uses[begin].low, uses[begin].high, kind});
  }
  return bad;
}

void include(Vec3& min, Vec3& max, Vec3 const& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    min[axis] = std::min(min[axis], point[axis]);
    max[axis] = std::max(max[axis], point[axis]);
  }
}

std::vector<MeshDefect> grouped(TriangleMesh const& mesh, std::vector<BadEdge> const& bad) {
  Groups groups(mesh.vertices.size());
  for (BadEdge const& edge : bad) groups.join(edge.low, edge.high);
  std::map<std::uint32_t, MeshDefect> defects;
  for (BadEdge const& edge : bad) {
    auto const [found, fresh] = defects.try_emplace(groups.of(edge.low));
    MeshDefect& defect = found->second;
    if (fresh) defect.min = defect.max = mesh.vertices[edge.low];
    ++(defect.*edge.kind);
    include(defect.min, defect.max, mesh.vertices[edge.low]);
    include(defect.min, defect.max, mesh.vertices[edge.high]);
  }
  std::vector<MeshDefect> list;
  for (auto const& [vertex, defect] : defects) list.push_back(defect);
  return list;
}

std::string counted(std::size_t count, std::string_view kind) {
  return fmt::format("{} {} edge{}", count, kind, count == 1 ? "" : "s");
}

std::string kinds_text(std::size_t open, std::size_t overlapping, std::size_t turned) {
  std::string text;
  for (auto const& [count, kind] : {std::pair(open, "open"), std::pair(overlapping, "overlapping"),
                                    std::pair(turned, "turned")})
    if (count > 0) text += (text.empty() ? "" : ", ") + counted(count, kind);
  return text;
}

std::string place_text(Vec3 const& place) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", place[0], place[1], place[2]);
}

}  // namespace

MeshReport report_on(TriangleMesh const& mesh) {
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.degenerate = mesh.degenerate;
  report.defects = grouped(mesh, bad_edges(mesh));
  for (MeshDefect const& defect : report.defects) {
    report.open_edges += defect.open;
    report.overlapping_edges += defect.overlapping;
    report.turned_edges += defect.turned;
  }
  if (mesh.vertices.empty()) return report;
  report.min = report.max = mesh.vertices.front();
  for (Vec3 const& vertex : mesh.vertices) include(report.min, report.max, vertex);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Triangle t = mesh.corners(i);
    for (Vec3& corner : t) corner = subtract(corner, report.min);  // small numbers, less rounding
    report.volume += dot(t[0], cross(t[1], t[2])) / 6.0;
  }
  return report;
}

std::string defects_text(MeshReport const& report, std::size_t most) {
  std::string text;
  std::size_t const shown = std::min(most, report.defects.size());
  for (std::size_t i = 0; i < shown; ++i) {
    MeshDefect const& defect = report.defects[i];
    text += fmt::format("{}{} around {} to {}", i == 0 ? "" : "; ",
                        kinds_text(defect.open, defect.overlapping, defect.turned),
                        place_text(defect.min), place_text(defect.max));
  }
  if (report.defects.size() > shown)
    text += fmt::format("; and {} more places", report.defects.size() - shown);
  return text;
}

}  // namespace moraine
