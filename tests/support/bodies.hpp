// Triangulated bodies of known volume, and STL files of them.
#pragma once

#include <string>
#include <vector>

#include "setup/mesh/triangle_mesh.hpp"

namespace moraine {

/// A cube of twelve triangles between two corners.
std::vector<Triangle> cube(Vec3 const& min, double edge);

/// A ball about the origin of `rings` rings of latitude, twice as many of longitude; all corners
/// lie on the sphere of the radius.
std::vector<Triangle> sphere(double radius, int rings);

/// A torus about z: radius `large` of the circle in the middle, `small` of the tube, `count`
/// segments around the tube, twice as many along it.
std::vector<Triangle> torus(double large, double small, int count);

/// Volume of a closed body [m^3].
double volume(std::vector<Triangle> const& triangles);

/// The bytes of an STL file; binary numbers are rounded to single precision.
std::string stl_text(std::vector<Triangle> const& triangles);
std::string stl_binary(std::vector<Triangle> const& triangles);

}  // namespace moraine
