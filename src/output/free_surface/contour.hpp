// The place where a function on a grid has a value: triangles in 3D, pieces of lines in 2D.
#pragma once

#include <cstdint>
#include <vector>

#include "output/free_surface/share_grid.hpp"

namespace moraine {

/// Points with unit normals, and cells of `corners` points each: 3 for triangles, 2 for lines.
struct Contour {
  std::size_t corners = 3;
  std::vector<Vec3> points;   // m
  std::vector<Vec3> normals;  // towards smaller values; zero where the function is flat
  std::vector<std::uint32_t> cells;
};

/// Marching tetrahedra (in 2D triangles): each cube of the grid is cut into the six tetrahedra of
/// Kuhn's subdivision, along its diagonal, and each of these is crossed by the plane that linear
/// interpolation along its edges gives. Source: Doi & Koide, IEICE Trans. E74 (1991) 214. Cubes cut
/// their common face alike, and a point on an edge is made once, so that the surface is closed
/// where the function is below `level` at all ends of the grid: each edge belongs to two triangles,
/// each end of a line to two lines. Triangles turn counterclockwise seen from the side of smaller
/// values, which lies right of a line.
Contour contour_at(NodeGrid const& grid, double level);

/// Area of the triangles [m^2], or length of the lines [m].
double size_of(Contour const& contour);

/// Volume inside of a closed surface [m^3], or area inside of closed lines [m^2].
double content_of(Contour const& contour);

}  // namespace moraine
