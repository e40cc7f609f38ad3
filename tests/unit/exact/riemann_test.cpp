#include "exact/riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/riemann_ideal_gas.hpp"
#include "exact/shock_tubes.hpp"
#include "unit/exact/integral.hpp"
#include "unit/exact/liquid_laws.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

RiemannSide gas_side(GasState const& gas, double gamma = 1.4) {
  IdealGas law;
  law.heat_capacity_ratio = gamma;
  return {law, gas.density, gas.velocity, gas.pressure / ((gamma - 1.0) * gas.density)};
}

/// A material in its reference state.
template <class T>
RiemannSide at_rest(T const& law) {
  return {law, law.reference_density, 0.0, law.reference_energy};
}

struct GasPair {
  GasState left;
  GasState right;
  double gamma;
};

// The published tubes, and gases from soft to stiff: two shocks, two rarefactions, one of each.
TEST(RiemannProblem, IsTheClosedFormForIdealGases) {
  std::vector<GasPair> pairs{{{1, 3, 1}, {2, -1, 0.5}, 1.1},
                             {{1, 0, 1e5}, {1000, 0, 1e5}, 5.0 / 3.0},
                             {{3, 0.5, 7}, {2, 0.4, 9}, 7.0}};
  for (ShockTube const& tube : shock_tubes) pairs.push_back({tube.left, tube.right, 1.4});
  constexpr double digits = 1e-12;  // measured: within 5e-15
  for (auto const& [left, right, gamma] : pairs) {
    RiemannIdealGas const closed(left, right, gamma);
    RiemannProblem const general(gas_side(left, gamma), gas_side(right, gamma));
    double const c =
        std::sqrt(gamma * std::max(left.pressure / left.density, right.pressure / right.density));
    EXPECT_NEAR(general.star_pressure() / closed.star_pressure(), 1.0, digits);
    EXPECT_NEAR(general.star_velocity(), closed.star_velocity(), digits * c);
    double const low = general.left_wave().head - 0.1 * c;
    double const high = general.right_wave()->head + 0.1 * c;
    for (int k = 0; k <= 97; ++k) {
      double const s = low + (high - low) * k / 97.0;
      FlowState const a = general.sample(s);
      FlowState const b = closed.sample(s);
      EXPECT_NEAR(a.density / b.density, 1.0, digits) << "gamma " << gamma << " x/t " << s;
      EXPECT_NEAR(a.velocity, b.velocity, digits * c);
      EXPECT_NEAR(a.pressure / b.pressure, 1.0, digits);
      EXPECT_NEAR(a.specific_energy / b.specific_energy, 1.0, digits);
    }
  }
}

// Two published tubes of stiffened gases: gas of 0.8 GPa on water, and water of 1 GPa on air
// (Saurel and Abgrall, J. Comput. Phys. 150 (1999) 425). The figures: Toro's eqs. (4.6) to (4.8)
// with all pressures shifted by p_inf, bisected in another language.
TEST(RiemannProblem, StiffenedGases) {
  StiffenedGas const stiff{7.15, 3.31e8};
  RiemannProblem const drive(gas_side({1270.0, 0.0, 8e8}),
                             {stiff, 1000.0, 0.0, stiff.energy_at_pressure(1000.0, 1e5)});
  EXPECT_NEAR(drive.star_pressure() / 542458860.332, 1.0, 1e-10);
  EXPECT_NEAR(drive.star_velocity() / 253.497474617, 1.0, 1e-10);
  StiffenedGas const water{4.4, 6e8};
  RiemannProblem const burst({water, 1000.0, 0.0, water.energy_at_pressure(1000.0, 1e9)},
                             gas_side({50.0, 0.0, 1e5}));
  EXPECT_NEAR(burst.star_pressure() / 14190477.2133, 1.0, 1e-10);
  EXPECT_NEAR(burst.star_velocity() / 482.610412127, 1.0, 1e-10);
}

struct MaterialPair {
  char const* name;
  RiemannSide left;
  RiemannSide right;
};

std::vector<MaterialPair> material_pairs() {
  RiemannSide fast_water = at_rest(WaterPolynomial{});
  fast_water.velocity = -800.0;
  RiemannSide pressed_tait = at_rest(Tait{});
  pressed_tait.density = 1100.0;
  pressed_tait.velocity = 40.0;
  RiemannSide const stiff{StiffenedGas{4.4, 6e8}, 1000.0, 0.0, 1070588.2};
  return {{"TNT into water", at_rest(Jwl{}), at_rest(WaterPolynomial{})},
          {"TNT into air", at_rest(Jwl{}), at_rest(IdealGas{})},
          {"TNT hit by water", at_rest(Jwl{}), fast_water},
          {"Tait into polynomial", pressed_tait, at_rest(WaterPolynomial{})},
          {"Steinberg's water hit", {SteinbergWater{}, 1000.0, 900.0, 0.0}, at_rest(Tait{})},
          {"stiffened gas into air", stiff, at_rest(IdealGas{})}};
}

double total_energy(FlowState const& at) {
  return at.density * (at.specific_energy + 0.5 * at.velocity * at.velocity);
}

/// Mass, momentum and energy that cross a place moving with `speed`, per area and time.
struct Flux {
  double mass, momentum, energy;
};
Flux flux(FlowState const& at, double speed) {
  double const u = at.velocity - speed;
  return {at.density * u, at.density * u * at.velocity + at.pressure,
          total_energy(at) * u + at.pressure * at.velocity};
}

// Differences are measured by the fluxes of a shock of that mass flux and speed.
void expect_same(Flux const& a, Flux const& b, double speed, std::string const& what) {
  constexpr double digits = 1e-10;
  double const u = std::fabs(speed);
  EXPECT_NEAR(a.mass, b.mass, digits * std::fabs(a.mass)) << what;
  EXPECT_NEAR(a.momentum, b.momentum, digits * std::fabs(a.mass) * u) << what;
  EXPECT_NEAR(a.energy, b.energy, digits * std::fabs(a.mass) * u * u) << what;
}

// Shocks neither make nor lose anything; nothing flows through a contact, and its sides push alike.
TEST(RiemannProblem, ConservesAcrossJumps) {
  int shocks = 0;
  for (auto const& [name, left, right] : material_pairs()) {
    RiemannProblem const solution(left, right);
    auto const across = [&, &name = name](Wave const& wave, RiemannSide const& side) {
      if (wave.kind != WaveKind::shock) return;
      FlowState const ahead{side.density, side.velocity,
                            side.law.pressure(side.density, side.specific_energy),
                            side.specific_energy};
      expect_same(flux(ahead, wave.head), flux(wave.behind, wave.head), wave.head, name);
      ++shocks;
    };
    across(solution.left_wave(), left);
    across(*solution.right_wave(), right);
    FlowState const& a = solution.left_wave().behind;
    FlowState const& b = solution.right_wave()->behind;
    double const c = left.law.sound_speed(left.density, left.specific_energy);
    EXPECT_NEAR(a.velocity, b.velocity, 1e-12 * c) << name;
    EXPECT_NEAR(a.pressure, b.pressure, 1e-10 * a.density * c * c) << name;
    // The states behind the waves are states of their materials.
    EXPECT_NEAR(left.law.pressure(a.density, a.specific_energy), a.pressure,
                1e-10 * a.density * c * c);
  }
  EXPECT_EQ(shocks, 7);
}

// What is between two places that the waves have not reached has changed by what went in there.
TEST(RiemannProblem, ConservesInTheLarge) {
  for (auto const& [name, left, right] : material_pairs()) {
    RiemannProblem const solution(left, right);
    Wave const& a = solution.left_wave();
    Wave const& b = *solution.right_wave();
    double const low = a.head - 100.0, high = b.head + 100.0;  // rays, m/s: t = 1 s
    auto const all = [&](auto const& density) {
      auto const f = [&](double s) { return density(solution.sample(s)); };
      return integral(f, {low, a.head, a.tail, solution.star_velocity()}) +
             integral(f, {solution.star_velocity(), b.tail, b.head, high});
    };
    FlowState const first = solution.sample(low), last = solution.sample(high);
    auto const expect = [&, &name = name](double found, double in, double out) {
      EXPECT_NEAR(found, in - out, 1e-10 * (std::fabs(in) + std::fabs(out))) << name;
    };
    Flux const in = flux(first, low), out = flux(last, high);
    expect(all([](FlowState const& s) { return s.density; }), in.mass, out.mass);
    expect(all([](FlowState const& s) { return s.density * s.velocity; }), in.momentum,
           out.momentum);
    expect(all(total_energy), in.energy, out.energy);
  }
}

TEST(RiemannProblem, MirrorsAndMovesWithTheFrame) {
  for (auto const& [name, left, right] : material_pairs()) {
    RiemannProblem const solution(left, right);
    RiemannSide moved_left = left, moved_right = right;
    moved_left.velocity += 300.0;
    moved_right.velocity += 300.0;
    RiemannProblem const moving(moved_left, moved_right);
    RiemannSide image_left = right, image_right = left;
    image_left.velocity = -right.velocity;
    image_right.velocity = -left.velocity;
    RiemannProblem const image(image_left, image_right);
    double const high = solution.right_wave()->head + 10.0;
    for (double s = solution.left_wave().head - 10.0; s < high; s += 0.0123 * high) {
      FlowState const expected = solution.sample(s);
      FlowState const shifted = moving.sample(s + 300.0);
      FlowState const back = mirrored(image.sample(-s));
      EXPECT_NEAR(shifted.density, expected.density, 1e-11 * expected.density) << name;
      EXPECT_NEAR(shifted.velocity - 300.0, expected.velocity, 1e-8) << name;
      EXPECT_NEAR(back.density, expected.density, 1e-11 * expected.density) << name;
      EXPECT_NEAR(back.velocity, expected.velocity, 1e-8) << name;
      EXPECT_NEAR(back.pressure, expected.pressure, 1e-11 * expected.pressure + 1e-2) << name;
    }
  }
}

// Small differences spread as sound: p* and u* of linear acoustics, to second order.
TEST(RiemannProblem, WeakWavesAreSound) {
  RiemannSide water = at_rest(WaterPolynomial{}), tait = at_rest(Tait{});
  water.specific_energy = 0.0;  // without pressure, like the other
  auto const impedance = [](RiemannSide const& side) {
    return side.density * side.law.sound_speed(side.density, side.specific_energy);
  };
  double last = 0.0;
  for (double const u : {1.0, 0.1}) {
    water.velocity = u;
    double const z = impedance(water) + impedance(tait);
    double const p = impedance(water) * impedance(tait) * u / z;
    double const error = std::fabs(RiemannProblem(water, tait).star_pressure() - p);
    EXPECT_LT(error, 0.01 * p);
    if (u < 1.0) {
      EXPECT_NEAR(error / last, 0.01, 1e-3) << "second order";
    }
    last = error;
  }
}

TEST(RiemannProblem, IntoVacuum) {
  // A gas escapes with 2 c / (gamma - 1): Landau and Lifshitz, section 99.
  for (double const gamma : {1.05, 1.4, 3.0}) {
    RiemannProblem const escape = RiemannProblem::into_vacuum(gas_side({2.0, 10.0, 5.0}, gamma));
    double const c = std::sqrt(gamma * 2.5);
    EXPECT_NEAR(escape.star_velocity(), 10.0 + 2.0 * c / (gamma - 1.0), 1e-10 * c / (gamma - 1.0));
    EXPECT_EQ(escape.star_pressure(), 0.0);
    EXPECT_NEAR(escape.left_wave().head, 10.0 - c, 1e-12 * c);
    EXPECT_EQ(escape.sample(escape.star_velocity() + 1.0).density, 0.0);
    // Inside the fan u - c = x/t and u + 2c/(gamma-1) is kept.
    FlowState const at = escape.sample(11.0);
    double const c_at = std::sqrt(gamma * at.pressure / at.density);
    EXPECT_NEAR(at.velocity - c_at, 11.0, 1e-11);
    EXPECT_NEAR(at.velocity + 2.0 * c_at / (gamma - 1.0), escape.star_velocity(),
                1e-10 * c / (gamma - 1.0));
  }
  // A liquid keeps a surface: its density at pressure zero.
  Tait const law{};
  RiemannProblem const jet = RiemannProblem::into_vacuum({law, 1050.0, 0.0, law.reference_energy});
  EXPECT_FALSE(jet.right_wave().has_value());
  EXPECT_NEAR(jet.left_wave().behind.density, 1000.0, 1e-9);
  // c = c_0 (rho/rho_0)^3: the integral of c d(rho)/rho in closed form.
  EXPECT_NEAR(jet.star_velocity(), 1480.0 / 3.0 * (std::pow(1.05, 3.0) - 1.0), 1e-9);
}

std::string refusal(RiemannSide const& left, RiemannSide const& right) {
  return message_of<std::domain_error>([&] { RiemannProblem(left, right); });
}

TEST(RiemannProblem, TellsVacuumAndCavitation) {
  // For a gas just at the limit of Toro, eq. (4.40): 2 (c + c) / (gamma - 1).
  double const limit = 4.0 * std::sqrt(1.4) / 0.4;
  auto const opening = [](double u) {
    return std::pair(gas_side({1, -0.5 * u, 1}), gas_side({1, 0.5 * u, 1}));
  };
  auto const [left, right] = opening(limit * (1.0 + 1e-9));
  EXPECT_EQ(refusal(left, right), "Riemann problem: the states move apart and leave a vacuum");
  auto const [slow_left, slow_right] = opening(limit * (1.0 - 1e-4));
  EXPECT_GT(RiemannProblem(slow_left, slow_right).star_pressure(), 0.0);
  RiemannSide away = at_rest(WaterPolynomial{});
  away.velocity = 5.0;
  EXPECT_EQ(refusal(at_rest(WaterPolynomial{}), away),
            "Riemann problem: the states move apart and the liquid cavitates");
  away.velocity = 0.05;  // the liquid's own 176 kPa give 0.12 m/s
  EXPECT_GT(RiemannProblem(at_rest(WaterPolynomial{}), away).star_pressure(), 0.0);
  EXPECT_EQ(message_of<std::invalid_argument>([] {
              RiemannProblem({IdealGas{}, 1.0, 0.0, -1.0}, {IdealGas{}, 1.0, 0.0, 1e5});
            }),
            "isentrope: the state has no density or no sound speed");
}

}  // namespace
}  // namespace moraine
