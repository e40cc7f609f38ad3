// What is known of wall particles besides their state: faces, slip, and how their walls move.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/vec3.hpp"
#include "motion/rigid_motion.hpp"
#include "walls/wall_face.hpp"

namespace moraine {

/// What the pair terms know of a wall particle besides its place.
struct WallPoint {
  static constexpr std::uint16_t at_rest = std::numeric_limits<std::uint16_t>::max();

  std::array<float, 3> normal;  // into the fluid, before any motion; zero behind edges and corners
  float depth;                  // m, behind the face of that normal
  bool free_slip;
  float clearance = 0.0F;        // m, radius of a ball of nothing but solid; 0: not known
  std::uint16_t body = at_rest;  // which of WallData::bodies it belongs to
};

/// A wall that moves as prescribed.
struct MovingWall {
  RigidMotion motion;
  double radius = 0.0;  // m, largest distance of its particles from motion.about
  RigidState state{};   // at the present time
};

/// Data of all wall particles.
struct WallData {
  std::vector<WallPoint> points;  // by global id minus first_id
  std::uint64_t first_id = 0;
  std::vector<MovingWall> bodies;
  std::vector<Vec3> start;  // m, places before any motion, as `points`; empty where nothing moves
  std::vector<WallFace> faces;  // of mirror and repulsive walls

  bool move() const { return !bodies.empty(); }
  bool push() const {
    return std::any_of(faces.begin(), faces.end(),
                       [](WallFace const& face) { return face.repulsion.strength > 0.0; });
  }
  bool turn() const {
    return std::any_of(bodies.begin(), bodies.end(),
                       [](MovingWall const& wall) { return wall.motion.rotation.given(); });
  }

  /// Unit normal of a point now; zero where it has none.
  Vec3 normal(WallPoint const& point) const {
    Vec3 const normal{point.normal[0], point.normal[1], point.normal[2]};
    return point.body == WallPoint::at_rest ? normal : bodies[point.body].state.turned(normal);
  }
  /// Velocity [m/s] and acceleration [m/s^2] of a point that is at x now.
  Vec3 velocity(WallPoint const& point, Vec3 const& x) const {
    return point.body == WallPoint::at_rest ? Vec3{} : bodies[point.body].state.velocity(x);
  }
  /// Angular velocity [rad/s] of the wall of a point.
  Vec3 angular_velocity(WallPoint const& point) const {
    return point.body == WallPoint::at_rest ? Vec3{} : bodies[point.body].state.angular_velocity();
  }
  Vec3 acceleration(WallPoint const& point, Vec3 const& x) const {
    return point.body == WallPoint::at_rest ? Vec3{} : bodies[point.body].state.acceleration(x);
  }
};

}  // namespace moraine
