#include "probes/point_probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel_for.hpp"
#include "probes/kernel_shape.hpp"

namespace moraine {
namespace {

struct Sums {
  double weight = 0.0;
  PointState state{};
};

Sums combine(Sums a, Sums const& b) {
  a.weight += b.weight;
  a.state.pressure += b.state.pressure;
  a.state.density += b.state.density;
  a.state.specific_energy += b.state.specific_energy;
  for (std::size_t k = 0; k < 3; ++k) a.state.velocity[k] += b.state.velocity[k];
  return a;
}

/// Adds particle i, seen from x, to the sums; sign: of its velocity along each axis.
void include(Sums& sums, ParticleStore const& store, std::size_t i, KernelName kernel, double all,
             std::array<double, 3> const& x, std::array<double, 3> const& sign = {1.0, 1.0, 1.0}) {
  bool const varies = store.has(Field::smoothing_length);
  double const h = varies ? store.scalar(Field::smoothing_length)[i] : all;
  double distance2 = 0.0;
  for (int axis = 0; axis < store.dimension(); ++axis) {
    double const d = x[static_cast<std::size_t>(axis)] - store.component(Field::position, axis)[i];
    distance2 += d * d;
  }
  if (distance2 >= kernel_support * kernel_support * h * h) return;
  // What is common to all weights drops out: where all have one h, so does h^d.
  double const spread = varies ? std::pow(all / h, store.dimension()) : 1.0;
  // Weights of a mean must not be negative, as some kernels are far outside.
  double const shape = kernel_shape(kernel, store.dimension(), std::sqrt(distance2) / h);
  double const w = spread * std::max(shape, 0.0) * store.scalar(Field::mass)[i] /
                   store.scalar(Field::density)[i];
  sums.weight += w;
  sums.state.pressure += w * store.scalar(Field::pressure)[i];
  sums.state.density += w * store.scalar(Field::density)[i];
  sums.state.specific_energy += w * store.scalar(Field::specific_energy)[i];
  for (int axis = 0; axis < store.dimension(); ++axis) {
    auto const k = static_cast<std::size_t>(axis);
    sums.state.velocity[k] += w * sign[k] * store.component(Field::velocity, axis)[i];
  }
}

PointState mean(Sums const& sums) {
  double const inverse =
      sums.weight > 0.0 ? 1.0 / sums.weight : std::numeric_limits<double>::quiet_NaN();
  PointState state = sums.state;
  state.pressure *= inverse;
  state.density *= inverse;
  state.specific_energy *= inverse;
  for (double& v : state.velocity) v *= inverse;
  return state;
}

}  // namespace

PointState probe_point(ParticleStore const& store, KernelName kernel, double h,
                       std::array<double, 3> const& x) {
  auto const add = [&](std::size_t begin, std::size_t end) {
    Sums sums;
    for (std::size_t i = begin; i < end; ++i) include(sums, store, i, kernel, h, x);
    return sums;
  };
  return mean(reduce_blocks(store.range(Kind::fluid).size(), Sums{}, add, combine));
}

PointState probe_point(ParticleStore const& store, Search const& search, KernelName kernel,
                       double h, std::array<double, 3> const& x) {
  Sums sums;
  search.for_each_fluid_near(x, std::max(kernel_support * h, search.largest_support()),
                             [&](std::size_t i, Search::Viewpoint const& from) {
                               include(sums, store, i, kernel, h, from.place, from.sign);
                             });
  return mean(sums);
}

double probe_front(ParticleStore const& store, MaterialId material, int axis, int direction) {
  auto const x = store.component(Field::position, axis);
  auto const farthest = [&](std::size_t begin, std::size_t end) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end; ++i)
      if (store.material()[i] == material) most = std::max(most, direction * x[i]);
    return most;
  };
  double const most =
      reduce_blocks(store.range(Kind::fluid).size(), -std::numeric_limits<double>::infinity(),
                    farthest, [](double a, double b) { return std::max(a, b); });
  return std::isfinite(most) ? direction * most : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace moraine
