// What the fluid does to a wall or a part of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.hpp"
#include "search/search.hpp"
#include "store/particle_store.hpp"
#include "surface/symmetry.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

/// A place of a face whose pressure stands for an area around it.
struct FaceSpot {
  Vec3 place{};       // m, before any motion
  double area = 0.0;  // m^(d-1)
};

/// A face without dummy particles, or what of it lies in a box.
struct FacePart {
  std::size_t face = 0;  // index in WallData::faces
  Vec3 low{}, high{};    // m, the box
  std::vector<FaceSpot> spots;
};

/// A set of wall particles and of faces, and the point that torques are taken about.
struct WallPart {
  std::vector<std::uint8_t> member;  // 1 or 0, by global id minus WallData::first_id
  Vec3 about{};                      // m
  std::vector<FacePart> faces{};
};

/// Load on a wall part. In 2D per metre of thickness, in 1D per square metre.
struct WallReading {
  Vec3 force{};                 // N, of the fluid on the wall
  Vec3 torque{};                // N m, right-handed; in 2D only the last component
  double mean_pressure = 0.0;   // Pa, over the wet area; 0 where nothing is wet
  double largest_pressure = 0;  // Pa, of a place as wide as the spacing; 0 where nothing is wet
  double wet_area = 0.0;        // m^2; m in 2D, 1 in 1D
};

/// Sums the loads on the wall particles of a part.
///
///   F = sum_w F_w,   T = sum_w (x_w - about) x F_w,   F_w = - sum_i m_i dv_i/dt|_w
///
/// over the forces of the pair sweep, viscosity and contact included: the force of a pair acts
/// along the line between both, so that F and T are exactly what the fluid loses.
/// Pressures are those of the fluid continued to the wall (terms/wall_extrapolation.hpp), taken
/// back from the first row of wall particles to the face, p = p_w + rho_w depth g . n; each of them
/// stands for spacing^(d-1) of the face. They may be negative; the force has no part that pulls.
/// Where walls move, g is less the acceleration of the wall. With symmetry planes force, torque and
/// area are those of the whole, mirror images included.
/// Walls without dummy particles: probes/face_probe.hpp.
/// `loads` belong to search.wet_walls(). Gravity in m/s^2, lengths in m.
struct WallSurroundings {
  ParticleStore const& store;
  Search const& search;
  WallData const& walls;
  std::span<WallLoad const> loads;
  Vec3 gravity;
  double spacing;
  Symmetry symmetry{};  // planes at the sides of the domain, whose corners follow
  Vec3 low{}, high{};   // m
  // Read by faces without dummy particles only.
  std::span<MirrorLoad const> mirror_loads{};
  double smoothing_length = 0.0;
  KernelName kernel = KernelName::wendland_c2;
};
WallReading probe_wall(WallSurroundings const& at, WallPart const& part);

}  // namespace moraine
