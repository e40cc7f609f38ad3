#include "sloshing/rigid_tank.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "support/shared_data.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

constexpr double pi = std::numbers::pi;

RigidTank tank_of(double length, double depth, double width = 1.0) {
  return {length, depth, width, 1000.0, 9.81};
}

TEST(RigidTank, FrequenciesOfDeepAndShallowWater) {
  RigidTank const deep = tank_of(1.0, 20.0), shallow = tank_of(100.0, 0.1);
  for (int n = 1; n <= 5; ++n)
    EXPECT_NEAR(sloshing_mode(deep, n).angular_frequency, std::sqrt(9.81 * n * pi), 1e-12);
  // Long waves run at sqrt(g d).
  EXPECT_NEAR(sloshing_mode(shallow, 1).frequency(), std::sqrt(0.981) / 200.0, 1e-8);
}

TEST(RigidTank, FrequenciesOfTheReferenceTable) {
  auto const file = shared_data("sloshing/tank_frequencies.csv");
  if (file.empty()) GTEST_SKIP() << no_shared_data;
  auto const rows = shared_rows(file);
  ASSERT_EQ(rows[0][4], "n");
  int compared = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i][5] != "0") continue;  // waves across the motion too
    SloshingMode const mode =
        sloshing_mode(tank_of(std::stod(rows[i][3]), std::stod(rows[i][1])), std::stoi(rows[i][4]));
    EXPECT_NEAR(mode.wave_number, std::stod(rows[i][6]), 1e-7 * mode.wave_number);
    EXPECT_NEAR(mode.angular_frequency, std::stod(rows[i][7]), 1e-7 * mode.angular_frequency);
    EXPECT_NEAR(mode.frequency(), std::stod(rows[i][8]), 1e-7 * mode.frequency());
    EXPECT_NEAR(mode.period(), std::stod(rows[i][9]), 1e-7 * mode.period());
    ++compared;
  }
  EXPECT_EQ(compared, 45);
}

// The table sums 200 odd modes, so its impulsive masses are high by the rest of the sum,
// 8/pi^3 L/d sum n^-3 from n = 401 on = 8/pi^3 L/d / (4 400^2); Housner's sqrt(3)/2 is 0.866 there.
TEST(RigidTank, MassesAndHeightsOfTheReferenceTable) {
  auto const file = shared_data("sloshing/tank_housner_masses.csv");
  if (file.empty()) GTEST_SKIP() << no_shared_data;
  auto const rows = shared_rows(file);
  ASSERT_EQ(rows[0].size(), 21u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<double> v;
    for (std::size_t k = 3; k < rows[i].size(); ++k) v.push_back(std::stod(rows[i][k]));
    RigidTank const tank = tank_of(v[0], std::stod(rows[i][1]), v[1]);
    std::string const name = rows[i][0] + rows[i][1] + rows[i][2];
    double const m = tank.mass();
    EXPECT_NEAR(m, v[2], 1e-7 * m) << name;
    HousnerTank const h = housner_tank(tank);
    EXPECT_NEAR(h.impulsive.mass / m, v[3], 4e-5 * v[3]) << name;
    EXPECT_NEAR(h.convective_mass / m, v[4], 1e-7) << name;
    EXPECT_NEAR(h.convective_angular_frequency / (2.0 * pi), v[8], 1e-6 * v[8]) << name;
    EXPECT_NEAR(h.impulsive.height.walls, v[9], 1e-6 * v[9]) << name;
    EXPECT_NEAR(h.convective_height.walls, v[10], 1e-6 * v[10]) << name;
    EXPECT_NEAR(h.impulsive.height.walls_and_floor, v[11], 5e-5 * v[11]) << name;
    EXPECT_NEAR(h.convective_height.walls_and_floor, v[12], 1e-6 * v[12]) << name;
    double const rest = 8.0 / (pi * pi * pi) * tank.length / tank.depth / (4.0 * 400.0 * 400.0);
    EXPECT_NEAR(impulsive_mass(tank).mass / m, v[13] - rest, 0.01 * rest + 1e-8) << name;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(sloshing_mode(tank, 2 * static_cast<int>(k) + 1).mass / m, v[14 + k],
                  1e-7 * v[14 + k])
          << name;
    EXPECT_NEAR(sloshing_mode(tank, 1).spring_height, v[17], 1e-7 * v[17]) << name;
  }
}

// All of the liquid is somewhere: modes and impulsive mass, and their moments.
TEST(RigidTank, ModesAndImpulsiveMassAreAllOfIt) {
  for (double const ratio : {0.1, 0.5, 1.0, 3.0, 12.0}) {
    RigidTank const tank = tank_of(2.0, 2.0 / ratio, 1.5);
    ImpulsiveMass const impulsive = impulsive_mass(tank);
    double mass = impulsive.mass;
    double walls = impulsive.mass * impulsive.height.walls;
    double floor = impulsive.mass * impulsive.height.walls_and_floor;
    int const last = 20001;
    for (int n = 1; n <= last; n += 2) {
      SloshingMode const mode = sloshing_mode(tank, n);
      mass += mode.mass;
      walls += mode.mass * mode.height.walls;
      floor += mode.mass * mode.height.walls_and_floor;
    }
    double const m = tank.mass(), d = tank.depth, l = tank.length;
    // The rest of the sum, 2/pi^3 L/d / last^2.
    double const rest = 1e-8 * ratio;
    EXPECT_NEAR(mass / m, 1.0, rest + 1e-12) << ratio;
    EXPECT_NEAR(walls / m, 0.5 * d, (rest + 1e-12) * d) << ratio;
    EXPECT_NEAR(floor / m, 0.5 * d + l * l / (12.0 * d), (rest + 1e-12) * (d + l * l / d)) << ratio;
  }
}

// In a shallow tank the impulsive mass is that of Westergaard's water before two walls,
// 2 x 0.543 rho d^2.
TEST(RigidTank, ImpulsiveMassOfLongTanksIsThatOfTwoWalls) {
  double const zeta_3 = 1.2020569031595942;
  // (2 rho/d) sum 1/lambda_n^3 with lambda_n = (2 n - 1) pi/(2 d): 14 zeta(3)/pi^3 rho d^2 a wall.
  double const one_wall = 14.0 * zeta_3 / (pi * pi * pi);
  EXPECT_NEAR(one_wall, 0.5427, 1e-4);
  RigidTank const tank = tank_of(60.0, 1.0);
  EXPECT_NEAR(impulsive_mass(tank).mass, 2.0 * one_wall * 1000.0, 1e-6 * 1000.0);
}

// The same at any ratio: m_0 = (2 rho/d) sum 2 tanh(lambda L/2) / lambda^3, liquid between two
// walls that move together, an expansion over the height and not over the length.
TEST(RigidTank, ImpulsiveMassByModesOverTheHeight) {
  for (double const ratio : {0.2, 1.0, 2.2 / 0.7, 10.0}) {
    RigidTank const tank = tank_of(ratio, 1.0);
    double sum = 0.0;
    for (int n = 1; n <= 4000; ++n) {
      double const lambda = (2.0 * n - 1.0) * pi / 2.0;
      sum += 4000.0 * std::tanh(0.5 * lambda * ratio) / (lambda * lambda * lambda);
    }
    EXPECT_NEAR(impulsive_mass(tank).mass, sum, 1e-6 * sum) << ratio;
  }
}

// The weight of the mass on a spring turns over as the lower height says.
TEST(RigidTank, SpringHeightLeavesRoomForTheWeight) {
  for (double const depth : {0.1, 0.7, 4.0})
    for (int n = 1; n <= 9; n += 2) {
      SloshingMode const mode = sloshing_mode(tank_of(2.2, depth), n);
      double const w = mode.angular_frequency;
      EXPECT_NEAR(mode.spring_height + 9.81 / (w * w), mode.height.walls_and_floor, 1e-12);
    }
}

// Housner's impulsive mass is 6 to 11 % above linear theory, unless the tank is much deeper than
// long.
TEST(RigidTank, HousnerIsHigh) {
  for (double const ratio : {0.5, 0.95, 2.0, 3.0, 6.0, 20.0}) {
    RigidTank const tank = tank_of(ratio, 1.0);
    double const high = housner_tank(tank).impulsive.mass / impulsive_mass(tank).mass - 1.0;
    EXPECT_GT(high, 0.06) << ratio;
    EXPECT_LT(high, 0.11) << ratio;
  }
}

// At the ends of the range: two walls of Westergaard, and liquid that moves as a whole.
TEST(RigidTank, HoldsFromShallowToDeep) {
  RigidTank const shallow = tank_of(1e4, 1.0), deep = tank_of(1.0, 1e4);
  EXPECT_NEAR(impulsive_mass(shallow).mass, 28.0 * 1.2020569031595942 / (pi * pi * pi) * 1000.0,
              1e-5 * 1e7 * 1e-4);
  EXPECT_NEAR(impulsive_mass(deep).mass / deep.mass(), 1.0, 1e-4);
  HousnerTank const housner = housner_tank(deep);
  for (double const height :
       {housner.convective_height.walls, housner.convective_height.walls_and_floor})
    EXPECT_NEAR(height, 1e4 - 1.0 / 3.16, 1e-6);
}

TEST(RigidTank, RefusesWhatIsNoTank) {
  char const* const all = "rigid tank: length, depth, width, density and gravity must be positive";
  EXPECT_EQ(message_of<std::invalid_argument>([] { check_tank({1.0, 0.0}); }), all);
  EXPECT_EQ(message_of<std::invalid_argument>([] { impulsive_mass({NAN, 1.0}); }), all);
  EXPECT_EQ(message_of<std::invalid_argument>([] {
              sloshing_mode({1.0, 1.0}, 0);
            }),
            "sloshing mode: modes count from 1");
  EXPECT_EQ(sloshing_mode({1.0, 1.0}, 2).mass, 0.0);
  char const* const ratio = "rigid tank: length over depth must be 0.0001 to 10000";
  EXPECT_EQ(message_of<std::invalid_argument>([] { impulsive_mass({2.0, 1e-9}); }), ratio);
  EXPECT_EQ(message_of<std::invalid_argument>([] { housner_tank({1.0, 2e4}); }), ratio);
}

}  // namespace
}  // namespace moraine
