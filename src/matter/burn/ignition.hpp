// Where an explosive is lit, and when the front gets anywhere from there.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace moraine {

/// Places at which an explosive is lit, all at the same moment.
struct Ignition {
  using Place = std::array<double, 3>;  // m
  struct Line {
    Place from, to;  // a straight piece between the two
  };
  struct Plane {
    Place point, normal;  // normal of any length but zero
  };

  std::vector<Place> points{};
  std::optional<Line> line{};
  std::optional<Plane> plane{};
  double delay = 0.0;  // s after the particles became this explosive

  bool any() const { return !points.empty() || line || plane; }

  /// Shortest straight way to any of the places [m]; infinite where there are none. The front is
  /// taken to run along it, whatever lies between.
  double distance(Place const& from) const;
};

}  // namespace moraine
