// The size of a crater in ground that was flat.
#pragma once

#include "probes/surface_height.hpp"

namespace moraine {

/// Where a crater is looked for.
struct CraterPlace {
  double level = 0.0;    // m, height of the original surface
  Vec3 center{};         // m, a place on the axis
  double radius = 0.0;   // m, how far from the axis; infinite: to the end of the domain
  int sectors = 16;      // of the azimuth, in 3D
  Vec3 low{}, high{};    // m, corners of the domain
  double spacing = 0.0;  // m, of the particles
};

/// Of the whole crater, also where symmetry planes leave a part of it.
struct CraterReading {
  double apparent_diameter = 0.0;  // m, at the original level
  double rim_diameter = 0.0;       // m, from rim to rim
  double depth = 0.0;              // m, of the deepest place below the original level
  double volume = 0.0;             // m^3 (2D: m^2) below the original level
  double rim_height = 0.0;         // m, above the original level
};

/// Profiles of the surface (surface_height) along rays from the axis, sampled every half spacing:
/// in 2D to both sides, in 3D in the middle of each sector of the azimuth; each as far as `radius`,
/// the domain and the ground go. Diameters are twice the mean radius of the rays, the rim height
/// the mean of theirs, the depth that of the deepest place of any, the volume
///
///   3D: 2 pi mean(integral of depth r dr),   2D: 2 mean(integral of depth dr).
///
/// Rays that leave the domain within two spacings, as beyond a symmetry plane through the axis, do
/// not count: the others stand for them. A place without ground between places with ground counts
/// as deep as the lowest particle. The least depth that counts is a quarter of the spacing
/// (crater_profile.hpp, also for what is not a number). All not numbers where there is no ground.
CraterReading probe_crater(BodyView const& ground, CraterPlace const& at);

}  // namespace moraine
