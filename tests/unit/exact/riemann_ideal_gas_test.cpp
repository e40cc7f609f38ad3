#include "exact/riemann_ideal_gas.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "support/reference_data.hpp"

namespace moraine {
namespace {

GasState const sod_left{1.0, 0.0, 1.0};
GasState const sod_right{0.125, 0.0, 0.1};

void expect_same(FlowState const& a, FlowState const& b, double tolerance) {
  EXPECT_NEAR(a.density, b.density, tolerance);
  EXPECT_NEAR(a.velocity, b.velocity, tolerance);
  EXPECT_NEAR(a.pressure, b.pressure, tolerance);
  EXPECT_NEAR(a.specific_energy, b.specific_energy, tolerance);
}

struct StarCase {
  GasState left;
  GasState right;
  double pressure;
  double velocity;
};

// Toro, table 4.3: the five test problems of table 4.1, printed to five or six digits.
TEST(RiemannIdealGas, StarValuesOfToro) {
  for (auto const& [left, right, p, u] : {
           StarCase{sod_left, sod_right, 0.30313, 0.92745},
           StarCase{{1.0, -2.0, 0.4}, {1.0, 2.0, 0.4}, 0.00189, 0.0},
           StarCase{{1.0, 0.0, 1000.0}, {1.0, 0.0, 0.01}, 460.894, 19.5975},
           StarCase{{1.0, 0.0, 0.01}, {1.0, 0.0, 100.0}, 46.0950, -6.19633},
           StarCase{{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1691.64, 8.68975},
       }) {
    RiemannIdealGas const solution(left, right, 1.4);
    double const digits = p < 1 ? 5e-6 : 1e-5 * p;
    EXPECT_NEAR(solution.star_pressure(), p, digits);
    EXPECT_NEAR(solution.star_velocity(), u, 1e-5 * std::max(1.0, std::fabs(u)));
  }
}

// The jump conditions across Sod's shock and contact, the invariants across its fan.
TEST(RiemannIdealGas, WavesOfSodObeyTheirLaws) {
  double const gamma = 1.4;
  RiemannIdealGas const sod(sod_left, sod_right, gamma);
  double const u = sod.star_velocity();
  FlowState const before = sod.sample(10.0);
  FlowState const behind = sod.sample(u + 1e-9);
  double const shock = behind.density * u / (behind.density - before.density);
  double const flux_before = before.density * shock * shock + before.pressure;
  double const flux_behind = behind.density * (u - shock) * (u - shock) + behind.pressure;
  EXPECT_NEAR(flux_before, flux_behind, 1e-14);
  auto const head = [](FlowState const& gas, double speed) {
    return gas.specific_energy + gas.pressure / gas.density + 0.5 * speed * speed;
  };
  EXPECT_NEAR(head(before, shock), head(behind, u - shock), 1e-13);
  expect_same(sod.sample(shock + 1e-9), before, 0.0);
  expect_same(sod.sample(shock - 1e-9), behind, 0.0);

  double const c_left = std::sqrt(gamma);
  expect_same(sod.sample(-c_left - 1e-9), {1.0, 0.0, 1.0, 2.5}, 1e-15);
  for (double const s : {-1.1, -0.6, -0.08, 0.5}) {  // the last one is behind the fan
    FlowState const gas = sod.sample(s);
    double const c = std::sqrt(gamma * gas.pressure / gas.density);
    EXPECT_NEAR(gas.velocity + 5.0 * c, 5.0 * c_left, 1e-14);
    EXPECT_NEAR(gas.pressure / std::pow(gas.density, gamma), 1.0, 1e-14);
    if (s < 0.0) {
      EXPECT_NEAR(gas.velocity - c, s, 1e-14);
    }
  }
}

TEST(RiemannIdealGas, MirrorsAndMovesWithTheFrame) {
  RiemannIdealGas const sod(sod_left, sod_right, 1.4);
  RiemannIdealGas const mirrored(sod_right, sod_left, 1.4);
  GasState left = sod_left;
  GasState right = sod_right;
  left.velocity = right.velocity = 3.0;
  RiemannIdealGas const moving(left, right, 1.4);
  for (double s = -1.975; s < 2.0; s += 0.05) {
    FlowState const expected = sod.sample(s);
    FlowState image = mirrored.sample(-s);
    image.velocity = -image.velocity;
    expect_same(image, expected, 1e-13);
    FlowState shifted = moving.sample(s + 3.0);
    shifted.velocity -= 3.0;
    expect_same(shifted, expected, 1e-12);
  }
}

// Two equal streams meet: for a strong shock the density rises to (gamma+1)/(gamma-1).
TEST(RiemannIdealGas, StrongCollision) {
  RiemannIdealGas const noh({1.0, 1.0, 1e-12}, {1.0, -1.0, 1e-12}, 5.0 / 3.0);
  EXPECT_NEAR(noh.star_velocity(), 0.0, 1e-15);
  EXPECT_NEAR(noh.star_pressure(), 4.0 / 3.0, 1e-9);
  EXPECT_NEAR(noh.sample(0.0).density, 4.0, 1e-9);
  EXPECT_NEAR(noh.sample(1.0 / 3.0 - 1e-6).density, 4.0, 1e-9);
  EXPECT_NEAR(noh.sample(1.0 / 3.0 + 1e-6).density, 1.0, 1e-9);
}

std::string message_of(GasState const& left, GasState const& right, double gamma) {
  try {
    RiemannIdealGas const solution(left, right, gamma);
  } catch (std::invalid_argument const& error) {
    return error.what();
  }
  return "";
}

TEST(RiemannIdealGas, RefusesWhatItCannotSolve) {
  EXPECT_EQ(message_of(sod_left, sod_right, 1.0),
            "Riemann problem: the heat capacity ratio must be above 1");
  EXPECT_EQ(message_of(sod_left, {1.0, 0.0, 0.0}, 1.4),
            "Riemann problem: density and pressure must be positive");
  EXPECT_EQ(message_of({1.0, -6.0, 1.0}, {1.0, 6.0, 1.0}, 1.4),
            "Riemann problem: the states move apart and leave a vacuum");
}

struct TableCase {
  std::string file;
  GasState left;
  GasState right;
  double time;
  double position;  // of the discontinuity
};

class RiemannTable : public testing::TestWithParam<TableCase> {};

// Tables with twelve digits, computed apart in another language. No row stands on a jump.
TEST_P(RiemannTable, Agrees) {
  auto const& [file, left, right, time, position] = GetParam();
  RiemannIdealGas const solution(left, right, 1.4);
  auto const rows = reference_data(file);
  EXPECT_EQ(rows.size(), 50u);
  for (auto const& row : rows) {
    FlowState const gas = solution.sample((row[0] - position) / time);
    double const digits = 1e-10;
    EXPECT_NEAR(gas.density, row[1], digits * (1.0 + row[1])) << "x = " << row[0];
    EXPECT_NEAR(gas.velocity, row[2], digits * (1.0 + std::fabs(row[2]))) << "x = " << row[0];
    EXPECT_NEAR(gas.pressure, row[3], digits * (1.0 + row[3])) << "x = " << row[0];
    EXPECT_NEAR(gas.specific_energy, row[4], digits * (1.0 + row[4])) << "x = " << row[0];
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, RiemannTable,
    testing::Values(TableCase{"riemann_sod_t0.2.csv", sod_left, sod_right, 0.2, 0.5},
                    TableCase{"riemann_toro2_t0.15.csv", {1, -2, 0.4}, {1, 2, 0.4}, 0.15, 0.5},
                    TableCase{"riemann_toro3_t0.012.csv", {1, 0, 1000}, {1, 0, 0.01}, 0.012, 0.5}));

}  // namespace
}  // namespace moraine
