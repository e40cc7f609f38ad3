#include "verify/radial_flow.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace moraine {

Case about_origin(Case c, FlowGeometry geometry, double radius) {
  c.dimension = dimensions(geometry);
  c.domain = {};
  c.symmetry = {};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis) {
    c.domain.max[axis] = 2.0 * radius;
    c.symmetry.planes[axis][0] = true;
  }
  if (c.dimension == 1)
    c.regions.front().shape = Box{{}, {radius, 0.0, 0.0}};
  else
    c.regions.front().shape = Disc{{}, radius};
  return c;
}

double distance_from_origin(ParticleStore const& store, std::size_t particle) {
  double square = 0.0;
  for (int axis = 0; axis < store.dimension(); ++axis)
    square += std::pow(store.component(Field::position, axis)[particle], 2);
  return std::sqrt(square);
}

double mean_in_shell(Simulation const& simulation, Field field, double from, double to) {
  ParticleStore const& store = simulation.particles();
  double sum = 0.0, volume = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const r = distance_from_origin(store, i);
    if (!(r >= from && r < to)) continue;
    double const own = store.scalar(Field::mass)[i] / store.scalar(Field::density)[i];
    sum += own * store.scalar(field)[i];
    volume += own;
  }
  return sum / volume;
}

double radius_of_pressure(Simulation const& simulation, double level, double width) {
  ParticleStore const& store = simulation.particles();
  std::vector<double> sum, volume;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    auto const shell = static_cast<std::size_t>(distance_from_origin(store, i) / width);
    if (shell >= sum.size()) sum.resize(shell + 1), volume.resize(shell + 1);
    double const own = store.scalar(Field::mass)[i] / store.scalar(Field::density)[i];
    sum[shell] += own * store.scalar(Field::pressure)[i];
    volume[shell] += own;
  }
  double outer = 0.0;
  for (std::size_t shell = sum.size(); shell-- > 0;) {
    double const inner = volume[shell] > 0.0 ? sum[shell] / volume[shell] : 0.0;
    if (inner >= level)
      return width * (static_cast<double>(shell) + 0.5 + (inner - level) / (inner - outer));
    outer = inner;
  }
  return 0.0;
}

}  // namespace moraine
