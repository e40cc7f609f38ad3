// Images at mirror walls, as optional terms see them, against real particles in their places.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "setup/build_model.hpp"
#include "support/charge_in_box.hpp"
#include "support/option_reference.hpp"
#include "support/small_models.hpp"

namespace moraine {
namespace {

using charge::charge_in_box;
using charge::spacing;

constexpr int side = 24;
constexpr double size = side * spacing;  // m
constexpr double sound_speed = 100.0;    // m/s

/// Gravity into the corner of the two mirrors.
Point const gravity{-4.0, -9.81, 0.0};  // m/s^2

/// Disordered water in a corner of two mirrors, with the pressure and the density of hydrostatics,
/// both linear, and slow velocities.
Model water_in_corner(Slip slip) {
  Case c = charge_in_box(2, side, WallMethod::dummy, slip);
  Linear water;
  water.reference_sound_speed = sound_speed;
  c.materials = {{"water", water}};
  c.regions.pop_back();
  c.gravity = gravity;
  c.numerics.viscosity_alpha = c.numerics.viscosity_beta = 0.0;
  c.walls[0].method = WallMethod::mirror;
  c.walls[0].open[0][1] = c.walls[0].open[1][1] = true;
  end_domain_at_mirrors(c);
  Model model = build_model(c);
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.size(); ++i) {
    auto const id = static_cast<double>(store.id()[i]);
    double compression = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      double& x = store.component(Field::position, axis)[i];
      x += 0.15 * spacing * std::sin(2.3 * id + axis);
      store.component(Field::velocity, axis)[i] = 1e-3 * std::sin(1.1 * id + 2 * axis);
      compression +=
          gravity[static_cast<std::size_t>(axis)] * (x - size) / (sound_speed * sound_speed);
    }
    store.scalar(Field::density)[i] = 1000.0 * (1.0 + compression);
    store.scalar(Field::pressure)[i] = 1000.0 * sound_speed * sound_speed * compression;
    store.scalar(Field::sound_speed)[i] = sound_speed;
  }
  return model;
}

void append_reflection(ParticleStore& store, std::size_t i, std::array<bool, 2> across, Slip slip) {
  std::size_t const image = store.append(Kind::fluid, store.material()[i]);
  double head = 0.0;  // g . (x' - x)
  for (std::size_t a = 0; a < 2; ++a) {
    int const axis = static_cast<int>(a);
    double const x = store.component(Field::position, axis)[i];
    store.component(Field::position, axis)[image] = across[a] ? -x : x;
    if (across[a]) head -= 2.0 * gravity[a] * x;
    bool const turned = slip == Slip::free ? across[a] : across[0] != across[1];
    double const v = store.component(Field::velocity, axis)[i];
    store.component(Field::velocity, axis)[image] = turned ? -v : v;
  }
  double const rho = store.scalar(Field::density)[i];
  store.scalar(Field::density)[image] = rho + 1000.0 * head / (sound_speed * sound_speed);
  store.scalar(Field::pressure)[image] = store.scalar(Field::pressure)[i] + rho * head;
  for (Field const field : {Field::mass, Field::sound_speed})
    store.scalar(field)[image] = store.scalar(field)[i];
}

/// The same without mirrors: what they would show stands behind them as water.
Model water_behind_mirrors(Model model, Slip slip) {
  ParticleStore& store = model.particles;
  std::size_t const count = store.size();
  for (std::size_t i = 0; i < count; ++i)
    for (auto const across : {std::array{true, false}, {false, true}, {true, true}})
      append_reflection(store, i, across, slip);
  model.mirror_walls = {};
  for (std::size_t a = 0; a < 2; ++a) model.domain_min[a] = -2.0 * size;
  return model;
}

/// Rates of one field component by id, of particles that no free side is near.
std::vector<double> rates(Model const& model, Field field, int axis) {
  ParticleStore const& store = model.particles;
  double const inside = size - 6.0 * model.numerics.smoothing_length();
  std::vector<double> values(side * side, 0.0);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    if (store.id()[i] < values.size() && store.component(Field::position, 0)[i] < inside &&
        store.component(Field::position, 1)[i] < inside)
      values[store.id()[i]] = store.component(field, axis)[i];
  return values;
}

/// Largest difference of the rates of a field between mirrors and water behind them.
double difference(void (*ask)(Numerics&), Slip slip, Field field, int axis) {
  Model mirrored = water_in_corner(slip);
  ask(mirrored.numerics);
  Model whole = water_behind_mirrors(mirrored, slip);
  find_rates(mirrored);
  find_rates(whole);
  auto const a = rates(mirrored, field, axis), b = rates(whole, field, axis);
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::fabs(a[k] - b[k]));
  return most;
}

// Images show the correction of their sources, whose neighbours are denser by g h / c^2, 1e-5, than
// those of the water behind the mirror; corrections push with up to g times the depth in smoothing
// lengths, 20.
TEST(MirrorsUnderGravity, CorrectedGradientsSeeWaterBehindThem) {
  auto const ask = [](Numerics& n) { n.gradient_correction = GradientCorrection::bonet_lok; };
  for (Slip const slip : {Slip::free, Slip::none})
    for (int const axis : {0, 1})
      EXPECT_LT(difference(ask, slip, Field::acceleration, axis), 2e-4 * 9.81);
}

// Linear densities have the same gradient on both sides: only rounding is left of what a density
// of hydrostatics changes in the time h / c.
TEST(MirrorsUnderGravity, DiffusionSeesWaterBehindThem) {
  auto const ask = [](Numerics& n) {
    n.density_diffusion = 0.1;
    n.diffusion = DiffusionForm::gradient;
  };
  double const scale = 1000.0 * 9.81 / sound_speed;  // kg/(m^3 s)
  for (Slip const slip : {Slip::free, Slip::none})
    EXPECT_LT(difference(ask, slip, Field::density_rate, 0), 1e-9 * scale);
}

}  // namespace
}  // namespace moraine
