#include "verify/thrown_block.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace moraine {

Case thrown_block(MaterialSpec const& material, double speed, double spacing) {
  Case c;
  c.dimension = 1;
  c.domain = {{-block_length, 0.0, 0.0}, {2.0 * block_length, 0.0, 0.0}};
  c.numerics.spacing = spacing;
  c.numerics.precision = Precision::full;
  c.time.end = 1.0;
  c.materials = {material};
  RegionSpec block{"block", material.name, Box{{0.0, 0.0, 0.0}, {block_length, 0.0, 0.0}}, {}};
  block.initial.velocity = {-speed, 0.0, 0.0};
  c.regions = {block};
  WallSpec wall;
  wall.name = "target";
  wall.box = {{0.0, 0.0, 0.0}, {2.0 * block_length, 0.0, 0.0}};
  wall.open[0][1] = true;
  c.walls = {wall};
  return c;
}

double crossing(Simulation const& simulation, ParticleValue value, double level) {
  ParticleStore const& store = simulation.particles();
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    points.emplace_back(store.component(Field::position, 0)[i], value(store, i));
  std::sort(points.begin(), points.end());
  for (std::size_t k = points.size() - 1; k > 0; --k) {
    auto const [x, here] = points[k - 1];
    auto const [x_next, next] = points[k];
    if (here >= level && next < level) return x + (x_next - x) * (here - level) / (here - next);
  }
  return 0.0;
}

Passage run_until(Simulation& simulation, ParticleValue value, double level, double place) {
  while (simulation.running() && crossing(simulation, value, level) < place) simulation.advance();
  return {simulation.time(), crossing(simulation, value, level)};
}

double speed_between(Passage const& first, Passage const& last) {
  return (last.place - first.place) / (last.time - first.time);
}

double mean_of(Simulation const& simulation, ParticleValue value, double from, double to) {
  ParticleStore const& store = simulation.particles();
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const x = store.component(Field::position, 0)[i];
    if (x < from || x > to) continue;
    sum += value(store, i);
    count += 1.0;
  }
  return sum / count;
}

}  // namespace moraine
