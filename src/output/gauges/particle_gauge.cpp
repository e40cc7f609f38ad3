// Gauges of kind particle.
#include <cmath>
#include <limits>
#include <memory>

#include "output/gauges/gauge_columns.hpp"
#include "output/gauges/makers.hpp"
#include "probes/solid_state.hpp"

namespace moraine {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

Vec3 vector_of(ParticleStore const& store, Field field, std::size_t i) {
  Vec3 vector{};
  for (int axis = 0; axis < store.dimension(); ++axis)
    vector[static_cast<std::size_t>(axis)] = store.component(field, axis)[i];
  return vector;
}

/// Number of the particle nearest to a place; the lowest of several, not a number without any.
double nearest(ParticleStore const& store, Vec3 const& place) {
  double best = nowhere;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    double const distance = norm(subtract(vector_of(store, Field::position, i), place));
    auto const id = static_cast<double>(store.id()[i]);
    if (distance > least || (distance == least && id > best)) continue;
    least = distance;
    best = id;
  }
  return best;
}

bool read_particle(ParticleStore const& store, std::size_t i, std::vector<double>& row) {
  for (Field const field : {Field::pressure, Field::density, Field::specific_energy})
    row.push_back(store.scalar(field)[i]);
  row.push_back(shear_norm(deviator_of(store, i)));
  for (Field const field : {Field::position, Field::velocity}) {
    Vec3 const vector = vector_of(store, field, i);
    row.insert(row.end(), vector.begin(), vector.begin() + store.dimension());
  }
  return true;
}

}  // namespace

GaugeReader particle_reader(Case const& c, GaugeSpec const& gauge) {
  auto const id = std::make_shared<std::vector<double>>(1, nowhere);  // exact below 2^53
  GaugeReader reader{gauge.name,
                     {{gauge.name + " pressure", "Pa"},
                      {gauge.name + " density", "kg/m^3"},
                      {gauge.name + " specific_energy", "J/kg"},
                      {gauge.name + " shear_stress", "Pa"}},
                     {},
                     id};
  add_vector_columns(reader.columns, gauge.name + " place", c.dimension, "m");
  add_vector_columns(reader.columns, gauge.name + " velocity", c.dimension, "m/s");
  reader.read = [place = gauge.position, id, columns = reader.columns.size()](
                    ReadingContext const& at, std::vector<double>& row) {
    ParticleStore const& store = at.simulation.particles();
    double& followed = id->front();
    if (std::isnan(followed)) followed = nearest(store, place);
    for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
      if (static_cast<double>(store.id()[i]) == followed) return read_particle(store, i, row);
    row.insert(row.end(), columns, nowhere);
    return false;
  };
  return reader;
}

}  // namespace moraine
