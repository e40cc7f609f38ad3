// A surface: what walls, finite elements and rigid bodies all show to particles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"
#include "surface/face_geometry.hpp"

namespace moraine {

/// A point in 1D, a segment in 2D, a triangle in 3D: indices of its corners (the first `dimension`
/// entries count) and which side the fluid is on.
struct Face {
  std::array<std::uint32_t, 3> vertex{};
  int side = +1;  // +1: the fluid is on the side of area_normal(corners), -1: on the other one
};

/// State of a place behind a face.
struct SurfaceSample {
  Vec3 position;      // m
  Vec3 velocity;      // m/s, as of a body that is rigidly bound to the face
  Vec3 acceleration;  // m/s^2, of the place on the face, that is at depth 0
  Vec3 normal;        // unit length, out of the solid into the fluid
};

/// The place of a surface that is nearest to some point.
struct SurfaceDistance {
  double distance = 0.0;  // m; positive in the fluid, negative in the solid
  std::size_t face = 0;
  FaceCoordinates uv{};
  Vec3 position{};
};

/// Moving faces with one owner. Vertices carry position, velocity, acceleration and the force that
/// particles put on them; the owner writes the first three and reads the last. Faces that share an
/// edge must share its vertices' places; the surface may have rims (a tank without a lid).
class Surface {
 public:
  /// Vertices at rest. Throws std::invalid_argument for a dimension other than 1, 2, 3, no faces, a
  /// corner that does not exist, a side other than +1 and -1 or a face without extent.
  Surface(int dimension, std::uint32_t owner, std::vector<Vec3> vertices, std::vector<Face> faces);

  int dimension() const { return dimension_; }
  /// Id of the wall or body that the surface belongs to.
  std::uint32_t owner() const { return owner_; }
  std::span<Face const> faces() const { return faces_; }

  std::span<Vec3> position() { return position_; }
  std::span<Vec3 const> position() const { return position_; }
  std::span<Vec3> velocity() { return velocity_; }
  std::span<Vec3 const> velocity() const { return velocity_; }
  std::span<Vec3> acceleration() { return acceleration_; }
  std::span<Vec3 const> acceleration() const { return acceleration_; }

  /// Unit normal of a face, out of the solid into the fluid.
  Vec3 normal(std::size_t face) const;
  /// Area in 3D [m^2], length in 2D [m], 1 in 1D.
  double area(std::size_t face) const;

  /// The place `depth` [m] behind the face (negative: in front of it): x = sum N x - depth n, and
  /// its velocity sum N v - depth dn/dt, with the shares N of the corners at uv.
  SurfaceSample sample(std::size_t face, FaceCoordinates const& uv, double depth) const;

  /// Adds `force` [N, per metre of thickness in 2D, per square metre in 1D] at uv, shared among the
  /// corners by N: their sum is the force, their moment that of the force at the place on the face,
  /// and their power that of the force at the place's velocity.
  void add_force(std::size_t face, FaceCoordinates const& uv, Vec3 const& force);
  std::span<Vec3 const> force() const { return force_; }
  void clear_forces();

  /// The nearest place, by looking at all faces, and the side of it that `point` is on. Where
  /// several faces are equally near (an edge, a vertex) their normals count by the angle of the
  /// face there: Baerentzen and Aanaes, IEEE Trans. Vis. Comput. Graph. 11 (2005) 243. Beyond a rim
  /// the surface counts as continued.
  SurfaceDistance distance(Vec3 const& point) const;

  /// Whether the point is in the solid; a point on the surface is not.
  bool inside_solid(Vec3 const& point) const { return distance(point).distance < 0.0; }

 private:
  Corners corners(std::vector<Vec3> const& values, std::size_t face) const;
  void check() const;

  int dimension_;
  std::uint32_t owner_;
  std::vector<Face> faces_;
  std::vector<Vec3> position_;
  std::vector<Vec3> velocity_;
  std::vector<Vec3> acceleration_;
  std::vector<Vec3> force_;
};

}  // namespace moraine
