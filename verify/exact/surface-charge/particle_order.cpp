#include "particle_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace moraine {
namespace {

using Place = std::array<double, 2>;  // m

/// The least way out of the domain [m]; zero beyond its sides, where a particle is about to be
/// removed.
double way_out(Model const& model, Place const& place) {
  double way = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 2; ++axis)
    way =
        std::min({way, place[axis] - model.domain_min[axis], model.domain_max[axis] - place[axis]});
  return std::max(way, 0.0);
}

}  // namespace

double asymmetry(Simulation const& simulation, std::vector<std::uint64_t> const& mirror) {
  ParticleStore const& store = simulation.particles();
  std::vector<std::optional<Place>> at(mirror.size());
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    at[store.id()[i]] = {store.component(Field::position, 0)[i],
                         store.component(Field::position, 1)[i]};
  double worst = 0.0;
  for (std::size_t id = 0; id < mirror.size(); ++id) {
    auto const& here = at[id];
    auto const& there = at[mirror[id]];
    if (!here) continue;  // told by its image
    worst = std::max(worst, there ? std::max(std::fabs((*here)[0] + (*there)[0]),
                                             std::fabs((*here)[1] - (*there)[1]))
                                  : way_out(simulation.model(), *here));
  }
  return worst / simulation.model().numerics.spacing;
}

std::vector<std::uint64_t> mirror_images(ParticleStore const& store) {
  std::size_t const count = store.range(Kind::fluid).size();
  std::vector<std::uint64_t> mirror(count);
  auto const x = store.component(Field::position, 0), y = store.component(Field::position, 1);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      if (std::fabs(x[i] + x[j]) < 1e-6 && std::fabs(y[i] - y[j]) < 1e-6 &&
          store.material()[i] == store.material()[j])
        mirror[store.id()[i]] = store.id()[j];
  return mirror;
}

int strangers(ParticleStore const& store) {
  std::size_t const count = store.range(Kind::fluid).size();
  auto const x = store.component(Field::position, 0), y = store.component(Field::position, 1);
  auto const mass = store.scalar(Field::mass), density = store.scalar(Field::density);
  int found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double const reach = 1.5 * std::sqrt(mass[i] / density[i]);
    int own = 0, other = 0;
    double side_x = 0.0, side_y = 0.0;  // sum of unit vectors to the others
    for (std::size_t j = 0; j < count; ++j) {
      if (j == i || std::fabs(x[i] - x[j]) > reach || std::fabs(y[i] - y[j]) > reach) continue;
      double const distance = std::hypot(x[i] - x[j], y[i] - y[j]);
      if (distance > reach) continue;
      (store.material()[i] == store.material()[j] ? own : other) += 1;
      side_x += (x[j] - x[i]) / distance;
      side_y += (y[j] - y[i]) / distance;
    }
    bool const around = std::hypot(side_x, side_y) < 0.5 * other;
    found += own == 0 && around ? 1 : 0;
  }
  return found;
}

}  // namespace moraine
