#include "setup/check_shape.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "base/units.hpp"
#include "setup/geometry.hpp"
#include "setup/mesh/stl_reader.hpp"
#include "setup/parameter.hpp"

namespace moraine {
namespace {

class ShapeCheck {
 public:
  ShapeCheck(std::string const& key, Case const& c, Source& source)
      : key_(key), case_(c), source_(source) {}

  bool operator()(Box const& box) const {
    if (!good({"box.min", "box.max"})) return false;
    bool sound = true;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
      if (!(box.min[axis] < box.max[axis]))
        sound =
            wrong("box.max", fmt::format("must be greater than min along {}", axis_names[axis]));
    return sound;
  }

  bool operator()(Disc const&) const { return good({"disc.center", "disc.radius"}); }

  bool operator()(HalfPlane& plane) const {
    if (!good({"half_plane.normal"})) return false;
    double const size = length(plane.normal);
    if (size == 0.0) return wrong("half_plane.normal", "must not be zero");
    // A unit vector stays as it is, to the bit: a used case must read back unchanged.
    if (std::abs(size - 1.0) < 1e-15) return true;
    for (double& component : plane.normal) component /= size;
    return true;
  }

  bool operator()(Cylinder const& cylinder) const {
    if (!good({"cylinder.start", "cylinder.end", "cylinder.radius"})) return false;
    if (case_.dimension == 1) return wrong("cylinder.start", "is not possible in 1D", "give a box");
    if (length(subtract(cylinder.end, cylinder.start)) > 0.0) return true;
    return wrong("cylinder.end", "must differ from start");
  }

  bool operator()(Polygon const& polygon) const {
    if (!good({"polygon.corners"})) return false;
    if (case_.dimension == 1)
      return wrong("polygon.corners", "is not possible in 1D", "give a box");
    std::string rule = defect_of(polygon);
    bool const sound = rule.empty() || wrong("polygon.corners", std::move(rule));
    return (case_.dimension == 3 ? check_prism(polygon) : check_plane()) && sound;
  }

  bool operator()(StlBody& stl) const {
    if (!good({"stl.file", "stl.units"})) return false;
    if (case_.dimension != 3)
      return wrong("stl.file", fmt::format("is a body in 3D; this case has {}D", case_.dimension),
                   "give a polygon");
    Conversion const unit = to_si("1 " + stl.units, Quantity::length);
    if (!unit.value) return wrong("stl.units", unit.rule, unit.hint);
    if (!(*unit.value > 0.0)) return wrong("stl.units", "must be a positive length");
    return load(stl, *unit.value);
  }

 private:
  bool good(std::initializer_list<std::string_view> names) const {
    for (auto const name : names)
      if (!source_.good(key_ + std::string(name))) return false;
    return true;
  }

  bool wrong(std::string_view name, std::string rule, std::string hint = {}) const {
    source_.report_value(key_ + std::string(name), std::move(rule), std::move(hint));
    return false;
  }

  bool check_plane() const {
    bool sound = true;
    for (auto const name : {"polygon.axis", "polygon.from", "polygon.to"})
      if (source_.has(key_ + name)) sound = wrong(name, "is given in 2D", "leave it out");
    return sound;
  }

  bool check_prism(Polygon const& polygon) const {
    bool sound = true;
    for (auto const& [end, name] :
         {std::pair(&polygon.from, "polygon.from"), std::pair(&polygon.to, "polygon.to")})
      if (!source_.has(key_ + name)) {
        source_.report_key(key_ + name, source_.place_of(key_ + "polygon.corners"),
                           "is missing: in 3D a polygon is a prism");
        sound = false;
      } else if (!*end) {
        sound = false;
      }
    if (sound && !(*polygon.from < *polygon.to))
      sound = wrong("polygon.to", "must be greater than from");
    return sound;
  }

  bool load(StlBody& stl, double scale_to_si) const {
    std::filesystem::path path = stl.file;
    if (path.is_relative()) path = std::filesystem::path(case_.file).parent_path() / path;
    std::vector<Triangle> triangles;
    try {
      triangles = read_stl(path);
    } catch (StlError const& error) {
      return wrong("stl.file", error.what());
    }
    for (Triangle& triangle : triangles)
      for (Vec3& corner : triangle) corner = add(stl.shift, scale(scale_to_si, corner));
    TriangleMesh mesh = weld(triangles);
    MeshReport report = report_on(mesh);
    std::error_code ignored;
    stl.file = std::filesystem::absolute(path, ignored).lexically_normal().string();
    if (mesh.triangles.empty()) return wrong("stl.file", "holds no triangle with an area");
    if (!report.watertight() && stl.defects == StlDefects::refuse)
      return wrong("stl.file", fmt::format("does not close a body: {}", defects_text(report)),
                   "mend it, or give defects = \"accept\" and look at moraine preview");
    stl.body = std::make_shared<MeshBody const>(
        MeshBody{std::move(report), WindingNumber(std::move(mesh))});
    return true;
  }

  std::string const& key_;
  Case const& case_;
  Source& source_;
};

constexpr std::array<std::pair<std::string_view, std::string_view>, std::variant_size_v<Shape>>
    words{{{"box.min", "box"},
           {"disc.center", "disc"},
           {"half_plane.point", "half-plane"},
           {"cylinder.start", "cylinder"},
           {"polygon.corners", "polygon"},
           {"stl.file", "body"}}};

}  // namespace

bool check_shape(Shape& shape, std::string const& key, Case const& c, Source& source) {
  return std::visit(ShapeCheck(key, c, source), shape);
}

bool is_complete(Shape const& shape, int dimension) {
  if (auto const* polygon = std::get_if<Polygon>(&shape))
    return polygon->size() > 0 && (dimension < 3 || (polygon->from && polygon->to));
  if (auto const* stl = std::get_if<StlBody>(&shape)) return stl->body != nullptr;
  return true;
}

std::string place_key(Shape const& shape, std::string const& key) {
  return key + std::string(words[shape.index()].first);
}

std::string_view word_for(Shape const& shape) { return words[shape.index()].second; }

}  // namespace moraine
