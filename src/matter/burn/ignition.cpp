#include "matter/burn/ignition.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moraine {
namespace {

using Place = Ignition::Place;

Place minus(Place const& a, Place const& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(Place const& a, Place const& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(Place const& a) { return std::hypot(a[0], a[1], a[2]); }

double distance_to(Ignition::Line const& line, Place const& from) {
  Place const along = minus(line.to, line.from);
  Place const way = minus(from, line.from);
  double const square = dot(along, along);
  double const part = square > 0.0 ? std::clamp(dot(way, along) / square, 0.0, 1.0) : 0.0;
  return length({way[0] - part * along[0], way[1] - part * along[1], way[2] - part * along[2]});
}

double distance_to(Ignition::Plane const& plane, Place const& from) {
  return std::fabs(dot(minus(from, plane.point), plane.normal)) / length(plane.normal);
}

}  // namespace

double Ignition::distance(Place const& from) const {
  double least = std::numeric_limits<double>::infinity();
  for (Place const& point : points) least = std::min(least, length(minus(from, point)));
  if (line) least = std::min(least, distance_to(*line, from));
  if (plane) least = std::min(least, distance_to(*plane, from));
  return least;
}

}  // namespace moraine
