// What the fluid does to faces of walls that have no dummy particles.
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "probes/wall_probe.hpp"

namespace moraine {

/// Adds the loads on the faces of a part to a reading: force, torque, and the pressures, summed
/// over the area (WallReading::mean_pressure), at the spots of the faces.
///
///   p = (sum_i p_i W + (g - a_w) . sum_i rho_i (x - x_i) W) / sum_i W
///
/// over the fluid within the support, as walls of dummies continue it
/// (terms/wall_extrapolation.hpp). A force acts along a line through the particle that bears it, so
/// that torques are exact; it belongs to the part when the foot of the particle on the face does.
void add_face_loads(WallSurroundings const& at, WallPart const& part, WallReading& reading);

}  // namespace moraine
