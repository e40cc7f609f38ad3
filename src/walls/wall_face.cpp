#include "walls/wall_face.hpp"

#include <algorithm>

namespace moraine {
namespace {

/// Particles of a face along an axis beside it.
FaceRow row_along(BoxWall const& wall, std::array<Vec3, 2> const& box, BoxSide const& side,
                  std::size_t along, double step, double range,
                  std::array<bool, 2> const& goes_on) {
  double const length = box[1][along] - box[0][along];
  int const intervals = std::max(1, static_cast<int>(std::lround(length / step)));
  FaceRow row{box[0][along], length / intervals, intervals + 1};
  for (std::size_t end = 0; end < 2; ++end) {
    bool const closed = !wall.open[along][end] && !spans_period(wall, along);
    int more = goes_on[end] ? static_cast<int>(std::ceil(range / row.step)) : 0;
    if (closed && along < side.axis) more = -1;  // that edge is of the other side
    row.count += more;
    if (end == 0) row.first -= more * row.step;
  }
  return row;
}

}  // namespace

std::vector<WallFace> make_wall_faces(BoxWall const& wall, double spacing,
                                      FaceRepulsion const& repulsion,
                                      std::array<std::array<bool, 2>, 3> const& goes_on) {
  check(wall);
  auto const box = covered_box(wall);
  std::vector<WallFace> faces;
  for (BoxSide const& side : closed_sides(wall)) {
    WallFace face;
    face.axis = side.axis;
    face.end = side.end;
    face.fluid_sign = side.fluid_sign;
    face.low = box[0];
    face.high = box[1];
    for (std::size_t k = static_cast<std::size_t>(wall.dimension); k < 3; ++k)
      face.low[k] = face.high[k] = 0.0;
    face.low[side.axis] = face.high[side.axis] = box[side.end][side.axis];
    face.repulsion = repulsion;
    for (std::size_t k = 0; k < static_cast<std::size_t>(wall.dimension); ++k)
      face.rows[k] = k == side.axis ? FaceRow{face.low[k], 0.0, 1}
                                    : row_along(wall, box, side, k, 0.5 * spacing, repulsion.range,
                                                goes_on[k]);
    faces.push_back(face);
  }
  return faces;
}

std::vector<Vec3> face_particles(WallFace const& face, int dimension) {
  std::vector<Vec3> places;
  std::array<int, 3> counts{1, 1, 1};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
    counts[k] = face.rows[k].count;
  for (int c = 0; c < counts[2]; ++c)
    for (int b = 0; b < counts[1]; ++b)
      for (int a = 0; a < counts[0]; ++a)
        places.push_back({face.rows[0].first + a * face.rows[0].step,
                          face.rows[1].first + b * face.rows[1].step,
                          face.rows[2].first + c * face.rows[2].step});
  return places;
}

}  // namespace moraine
