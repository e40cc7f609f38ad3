// A body with symmetry planes: one half, quarter or eighth must do what it does in the whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "probes/point_probe.hpp"
#include "probes/wall_probe.hpp"
#include "setup/build_model.hpp"
#include "setup/wall_parts.hpp"
#include "step/simulation_setup.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

struct Body {
  Case whole, part;
};

/// A charge in a closed box of water, which the planes x = 0, y = 0, z = 0 divide.
Body charge_in_box(int dimension, int side, int planes, Precision precision) {
  Case c;
  c.dimension = dimension;
  c.numerics.spacing = 0.01;
  c.numerics.precision = precision;
  double const half = 0.5 * side * c.numerics.spacing;
  Box box{};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    box.min[axis] = -half;
    box.max[axis] = half;
    c.domain.min[axis] = -2.0 * half;
    c.domain.max[axis] = 2.0 * half;
  }
  c.time.end = 1.0;
  c.time.fixed_step = 5e-7;
  c.materials = {{"water", WaterPolynomial{}}, {"tnt", Jwl{}}};
  c.regions = {{"sea", "water", box, {}}, {"charge", "tnt", Disc{{}, 0.3 * half}, {}}};
  WallSpec wall;
  wall.name = "box";
  wall.box = box;
  c.walls = {wall};
  GaugeSpec gauge;
  gauge.name = "load";
  gauge.kind = GaugeKind::wall;
  gauge.probe.wall = "box";
  c.gauges = {gauge};
  Body body{c, c};
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(planes); ++axis) {
    body.part.domain.min[axis] = 0.0;
    body.part.symmetry.planes[axis][0] = true;
  }
  return body;
}

/// Moves the particles of the part about, and those of the whole as their images say.
void disturb(Model& model, bool symmetric_axes[3]) {
  ParticleStore& store = model.particles;
  Range const fluid = store.range(Kind::fluid);
  double const s = model.numerics.spacing;
  for (std::size_t i = fluid.begin; i < fluid.end; ++i) {
    std::array<double, 3> x{}, sign{1.0, 1.0, 1.0};
    double phase = 0.0;
    for (int axis = 0; axis < model.dimension; ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      x[k] = store.component(Field::position, axis)[i];
      if (symmetric_axes[k] && x[k] < 0.0) sign[k] = -1.0;
      phase += (3.0 + 2.0 * axis) * std::round(sign[k] * x[k] / s * 2.0);
    }
    for (int axis = 0; axis < model.dimension; ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      store.component(Field::position, axis)[i] += sign[k] * 0.1 * s * std::sin(phase + axis);
      store.component(Field::velocity, axis)[i] += sign[k] * 200.0 * std::cos(phase - axis);
    }
  }
}

using State = std::array<double, 7>;  // place / spacing, velocity / 1000 m/s, density / 1000 kg/m^3

std::vector<State> states(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  std::vector<State> all(store.range(Kind::fluid).size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int axis = 0; axis < store.dimension(); ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      all[i][k] = store.component(Field::position, axis)[i] / 0.01;
      all[i][3 + k] = store.component(Field::velocity, axis)[i] / 1000.0;
    }
    all[i][6] = store.scalar(Field::density)[i] / 1000.0;
  }
  return all;
}

/// Largest difference of a particle of the part from the nearest in the whole, with particles
/// beyond a plane taken for their image.
double largest_difference(Simulation const& part, Simulation const& whole) {
  auto const all = states(whole);
  double worst = 0.0;
  for (State state : states(part)) {
    for (std::size_t k = 0; k < 3; ++k)
      if (part.model().symmetry.planes[k][0] && state[k] < 0.0) {
        state[k] = -state[k];
        state[3 + k] = -state[3 + k];
      }
    double nearest = 1e30;
    for (State const& other : all) {
      double difference = 0.0;
      for (std::size_t k = 0; k < state.size(); ++k)
        difference = std::max(difference, std::fabs(state[k] - other[k]));
      nearest = std::min(nearest, difference);
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}

struct Setting {
  int dimension, side, planes;
  Precision precision;
  double tolerance;  // rounding, grown over 60 steps of a violent flow
  Model (*with)(Model) = [](Model model) { return model; };
};

class SymmetryPlanes : public testing::TestWithParam<Setting> {};

TEST_P(SymmetryPlanes, PartDoesWhatTheWholeDoes) {
  auto const& [dimension, side, planes, precision, tolerance, with] = GetParam();
  Body const body = charge_in_box(dimension, side, planes, precision);
  bool symmetric[3] = {planes > 0, planes > 1, planes > 2};
  Model whole_model = with(build_model(body.whole));
  Model part_model = with(build_model(body.part));
  std::size_t const copies = static_cast<std::size_t>(part_model.symmetry.copies());
  ASSERT_EQ(part_model.particles.range(Kind::fluid).size() * copies,
            whole_model.particles.range(Kind::fluid).size());
  disturb(whole_model, symmetric);
  disturb(part_model, symmetric);
  Simulation whole(std::move(whole_model));
  Simulation part(std::move(part_model));
  for (int step = 0; step < 60; ++step) {
    whole.advance();
    part.advance();
  }
  EXPECT_GE(part.search().rebuilds(), 4u);
  EXPECT_EQ(part.lost().count, 0u);
  EXPECT_LE(largest_difference(part, whole), tolerance);

  Symmetry const& symmetry = part.model().symmetry;
  ConservedSums const a = part.sums(), b = whole.sums();
  EXPECT_NEAR(symmetry.whole(a.total_energy()) / b.total_energy(), 1.0, tolerance);
  EXPECT_NEAR(symmetry.whole(a.mass) / b.mass, 1.0, 1e-12);
  double const scale = std::sqrt(2.0 * b.mass * b.kinetic_energy);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(symmetry.whole(a.momentum)[k] / scale, b.momentum[k] / scale, tolerance);

  // Beside a plane a gauge sees the images, with their velocities reversed.
  std::array<double, 3> place{0.002, -0.03, 0.01};
  if (symmetric[1]) place[1] = 0.001;
  for (int axis = dimension; axis < 3; ++axis) place[static_cast<std::size_t>(axis)] = 0.0;
  double const h = part.model().numerics.smoothing_length();
  auto const kernel = part.model().numerics.kernel;
  PointState const seen = probe_point(part.particles(), part.search(), kernel, h, place);
  PointState const there = probe_point(whole.particles(), whole.search(), kernel, h, place);
  EXPECT_NEAR(seen.pressure / there.pressure, 1.0, 100 * tolerance);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(seen.velocity[k] / 1000.0, there.velocity[k] / 1000.0, 100 * tolerance);
}

INSTANTIATE_TEST_SUITE_P(, SymmetryPlanes,
                         testing::Values(Setting{1, 80, 1, Precision::full, 1e-9},
                                         Setting{2, 40, 1, Precision::full, 1e-9},
                                         Setting{2, 40, 2, Precision::full, 1e-9},
                                         Setting{2, 40, 2, Precision::mixed, 1e-3},
                                         Setting{3, 20, 3, Precision::full, 1e-9},
                                         Setting{2, 40, 2, Precision::full, 1e-9, with_options},
                                         Setting{2, 40, 1, Precision::full, 1e-9,
                                                 with_summed_density},
                                         Setting{3, 20, 3, Precision::full, 1e-9, with_options},
                                         Setting{2, 40, 1, Precision::full, 1e-9, with_strength},
                                         Setting{2, 40, 2, Precision::full, 1e-9, with_strength},
                                         Setting{3, 20, 3, Precision::full, 1e-9, with_strength}));

WallReading load_on_box(Case const& c, Simulation const& simulation) {
  Model const& model = simulation.model();
  std::vector<WallLoad> loads;
  simulation.pairs().loads_on_walls(simulation.particles(), simulation.search(), loads);
  return probe_wall({simulation.particles(), simulation.search(), model.walls, loads, model.gravity,
                     model.numerics.spacing, model.symmetry, model.domain_min, model.domain_max},
                    {wall_members(c, c.gauges[0]), {0.03, -0.02, 0.01}});
}

TEST(SymmetryPlane, LoadsOnWallsAreThoseOfTheWhole) {
  Body const body = charge_in_box(3, 16, 1, Precision::full);
  bool symmetric[3] = {true, false, false};
  Model whole_model = build_model(body.whole);
  Model part_model = build_model(body.part);
  disturb(whole_model, symmetric);
  disturb(part_model, symmetric);
  Simulation whole(std::move(whole_model));
  Simulation part(std::move(part_model));
  for (int step = 0; step < 30; ++step) {
    whole.advance();
    part.advance();
  }
  WallReading const a = load_on_box(body.part, part), b = load_on_box(body.whole, whole);
  EXPECT_NEAR(a.wet_area / b.wet_area, 1.0, 1e-12);
  EXPECT_NEAR(a.mean_pressure / b.mean_pressure, 1.0, 1e-8);
  double const scale = std::fabs(b.mean_pressure) * b.wet_area;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(a.force[k] / scale, b.force[k] / scale, 1e-9);
    EXPECT_NEAR(a.torque[k] / scale, b.torque[k] / scale, 1e-9);
  }
  EXPECT_GT(norm(b.torque) / scale, 1e-6);
}

/// Entries of all fields of one particle, by field and component.
std::vector<std::vector<double>> state_of(ParticleStore const& store, std::size_t i) {
  std::vector<std::vector<double>> state(field_count);
  for (FieldInfo const& field : field_table) {
    if (!store.has(field.field)) continue;
    for (int k = 0; k < components(field.rank, store.dimension()); ++k)
      state[static_cast<std::size_t>(field.field)].push_back(store.component(field.field, k)[i]);
  }
  return state;
}

// A particle that passes the plane x = 0 comes back as its image: vectors along x and entries of
// stress and velocity gradient with one x change their sign, all else stays.
TEST(SymmetryPlane, TurnsAllOfAParticleThatPasses) {
  for (int dimension = 1; dimension <= 3; ++dimension) {
    Model model = with_strength(build_model(charge_in_box(dimension, 12, 1, Precision::full).part));
    ParticleStore& store = model.particles;
    store.use(Field::drift);
    double number = 1.0;
    for (FieldInfo const& field : field_table)
      if (field.rank != Rank::scalar && store.has(field.field))
        for (int k = 0; k < components(field.rank, dimension); ++k)
          if (field.field != Field::position) store.component(field.field, k)[0] = number++;
    store.component(Field::position, 0)[0] = -1e-4;
    auto expected = state_of(store, 0);
    std::uint64_t const id = store.id()[0];
    Search search(search_settings(model));
    search.refresh(store);
    for (std::size_t f = 0; f < field_count; ++f) {
      auto& values = expected[f];
      Rank const rank = field_table[f].rank;
      if (values.empty() || rank == Rank::scalar) continue;
      if (rank == Rank::vector) values[0] *= -1.0;
      if (rank == Rank::symmetric && dimension == 2) values[2] *= -1.0;                     // xy
      if (rank == Rank::symmetric && dimension == 3) values[3] *= -1.0, values[4] *= -1.0;  // xy xz
      if (rank == Rank::matrix)
        for (std::size_t k = 1; k < static_cast<std::size_t>(dimension); ++k) {
          values[k] *= -1.0;
          values[k * static_cast<std::size_t>(dimension)] *= -1.0;
        }
    }
    auto const of_id = std::find(store.id().begin(), store.id().end(), id) - store.id().begin();
    EXPECT_EQ(state_of(store, static_cast<std::size_t>(of_id)), expected) << dimension << "D";
  }
}

}  // namespace
}  // namespace moraine
