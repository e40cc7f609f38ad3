// How often a surface winds around a point: inside or outside, for broken surfaces too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "setup/mesh/triangle_mesh.hpp"

namespace moraine {

/// Winding number of triangles around a point:
///
///   w(q) = 1/(4 pi) sum_t Omega_t(q),
///   tan(Omega/2) = a . (b x c) / (|a||b||c| + (a.b)|c| + (b.c)|a| + (c.a)|b|)
///
/// with a, b, c from q to the corners of t. Solid angle: van Oosterom and Strackee, IEEE Trans.
/// Biomed. Eng. 30 (1983) 125, eq. 8. For a closed surface w is the whole number of layers around
/// q, 1 inside and 0 outside, -1 inside of one turned inside out; near a hole it changes steadily,
/// and 1/2 closes the hole smoothly: Jacobson et al., ACM Trans. Graph. 32 (2013) 33.
class WindingNumber {
 public:
  explicit WindingNumber(TriangleMesh mesh);

  /// The sum over all triangles; exact to rounding.
  double exact(Vec3 const& q) const;

  /// The same with far clusters of triangles replaced by their dipole, A . (c - q) / (4 pi |c -
  /// q|^3), A the sum of their area vectors and c their middle; far means at least three times the
  /// radius of the cluster. Barill et al., ACM Trans. Graph. 37 (2018) 43, eq. 12. Off by less than
  /// 0.1 (tests), while inside and outside of a closed surface differ by 1.
  double operator()(Vec3 const& q) const;

  TriangleMesh const& mesh() const { return mesh_; }

 private:
  /// Triangles first ... first + count of the order; leaves have no children.
  struct Cluster {
    Vec3 middle{};       // m, weighted by area
    Vec3 area_vector{};  // m^2
    double radius = 0.0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t children = 0;  // index of the first of two; 0: leaf
  };

  void build(std::size_t index);
  void measure(Cluster& cluster) const;
  double sum(std::size_t index, Vec3 const& q) const;

  TriangleMesh mesh_;  // in the order of the clusters
  std::vector<Cluster> clusters_;
};

}  // namespace moraine
