#include "probes/point_probe.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace moraine {
namespace {

constexpr double spacing = 0.1;
constexpr double h = 0.13;

/// A block of 11^d particles about the origin; half of them have twice the mass and density.
/// Velocities are linear in the place, pressures constant.
ParticleStore block(int dimension) {
  ParticleStore store(dimension);
  int const side = 11;
  int const count = dimension == 1 ? side : (dimension == 2 ? side * side : side * side * side);
  for (int n = 0; n < count; ++n) {
    std::size_t const i = store.append(Kind::fluid, static_cast<MaterialId>(n % 2));
    int rest = n;
    double sum = 0.0;
    for (int axis = 0; axis < dimension; ++axis) {
      double const x = spacing * (rest % side - side / 2);
      rest /= side;
      store.component(Field::position, axis)[i] = x;
      sum += (axis + 1.0) * x;
    }
    for (int axis = 0; axis < dimension; ++axis)
      store.component(Field::velocity, axis)[i] = 2.0 + axis + sum;
    double const density = n % 2 == 0 ? 1000.0 : 2000.0;
    store.scalar(Field::density)[i] = density;
    store.scalar(Field::mass)[i] = density * std::pow(spacing, dimension);
    store.scalar(Field::pressure)[i] = 1e5;
    store.scalar(Field::specific_energy)[i] = -7.0;
  }
  return store;
}

// The shares of the particles add up to one: constants are exact wherever a particle is near, be it
// inside, at a face or beyond a corner.
TEST(PointProbe, IsExactForConstants) {
  for (int const dimension : {1, 2, 3})
    for (KernelName const kernel : {KernelName::cubic_spline, KernelName::wendland_c2})
      for (double const x : {0.0, 0.037, 0.5, 0.59, 0.62}) {
        PointState const state = probe_point(block(dimension), kernel, h, {x, 0.3 * x, 0.1 * x});
        EXPECT_NEAR(state.pressure, 1e5, 1e-9) << dimension << "D at " << x;
        EXPECT_NEAR(state.specific_energy, -7.0, 1e-13);
        EXPECT_GE(state.density, 1000.0);
        EXPECT_LE(state.density, 2000.0) << "a mean";
      }
}

// Shares are not consistent with linear fields except where particles are placed evenly about the
// point: at lattice points and half way between.
TEST(PointProbe, IsExactForLinearFieldsAtCentresOfSymmetry) {
  for (int const dimension : {1, 2, 3})
    for (double const x : {0.0, 0.05, 0.1}) {
      PointState const state = probe_point(block(dimension), KernelName::wendland_c2, h, {x, x, x});
      double sum = 0.0;
      for (int axis = 0; axis < dimension; ++axis) sum += (axis + 1.0) * x;
      for (int axis = 0; axis < dimension; ++axis)
        EXPECT_NEAR(state.velocity[static_cast<std::size_t>(axis)], 2.0 + axis + sum, 1e-13)
            << dimension << "D at " << x;
    }
}

// At a free surface only particles from inside count: the value is that of a place inside by less
// than the support.
TEST(PointProbe, IsOneSidedAtAFreeSurface) {
  PointState const state = probe_point(block(1), KernelName::wendland_c2, h, {0.5, 0.0, 0.0});
  EXPECT_LT(state.velocity[0], 2.5);
  EXPECT_GT(state.velocity[0], 2.5 - kernel_support * h);
}

TEST(PointProbe, HasNoNumberWhereNothingIsNear) {
  PointState const state =
      probe_point(block(2), KernelName::wendland_c2, h, {0.5 + 2.0 * h + 1e-9, 0.0, 0.0});
  for (double const value :
       {state.pressure, state.density, state.specific_energy, state.velocity[0]})
    EXPECT_TRUE(std::isnan(value));
}

TEST(FrontProbe, IsTheFarthestParticleOfItsMaterial) {
  ParticleStore store = block(2);
  store.component(Field::position, 0)[1] = 3.0;   // of material 1
  store.component(Field::position, 1)[2] = -4.0;  // of material 0
  EXPECT_EQ(probe_front(store, 1, 0, +1), 3.0);
  EXPECT_EQ(probe_front(store, 0, 0, +1), 0.5);
  EXPECT_EQ(probe_front(store, 0, 1, -1), -4.0);
  EXPECT_EQ(probe_front(store, 1, 1, -1), -0.5);
  EXPECT_TRUE(std::isnan(probe_front(store, 2, 0, +1))) << "there is none";
}

}  // namespace
}  // namespace moraine
