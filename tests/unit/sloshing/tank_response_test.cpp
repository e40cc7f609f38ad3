#include "sloshing/tank_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "records/synthetic_motion.hpp"
#include "support/records.hpp"
#include "support/shared_data.hpp"
#include "unit/output/scratch_folder.hpp"

namespace moraine {
namespace {

struct ReferenceTank {
  char const* file;
  double length, depth, width;
};

class TankHistory : public testing::TestWithParam<ReferenceTank> {};

// Histories that another program computed with the same modes, damping and recurrences, printed to
// six digits: half of the last digit is at most 5e-6 of a value. The sign of its force is that of
// the ground's acceleration.
TEST_P(TankHistory, AgreesWithTheReference) {
  auto const& [name, length, depth, width] = GetParam();
  auto const file = shared_data(std::string("sloshing/linear_elcentro_") + name + ".csv");
  auto const motion = shared_data("seismic/elcentro1940_NS_peknold.csv");
  if (file.empty() || motion.empty()) GTEST_SKIP() << no_shared_data;
  GroundRecord record{"", 0.02, 0.0, {}};
  for (auto const& row : shared_rows(motion))
    if (row[0] != "t_s") record.acceleration.push_back(std::stod(row[1]) * 9.81);
  auto const rows = shared_rows(file);
  TankResponse const r = tank_response({length, depth, width, 1000.0, 9.81}, record, {});
  ASSERT_EQ(rows.size() - 1, record.size() - 1) << "the table leaves out the last instant";
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    double const surface = std::stod(rows[i + 1][2]), force = std::stod(rows[i + 1][3]);
    ASSERT_NEAR(r.surface[i], surface, 5.01e-6 * std::fabs(surface) + 1e-15) << i;
    ASSERT_NEAR(-r.force[i], force, 5.01e-6 * std::fabs(force)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(ElCentro, TankHistory,
                         testing::Values(ReferenceTank{"koh_x_h0.7", 2.2, 0.7, 1.15},
                                         ReferenceTank{"koh_y_h0.7", 1.15, 0.7, 2.2},
                                         ReferenceTank{"rc50_x_h8", 50.0, 8.0, 20.0},
                                         ReferenceTank{"rc50_y_h8", 20.0, 8.0, 50.0}));

RigidTank const tank{2.0, 1.0, 1.5, 1000.0, 9.81};

// Slowly growing, then even acceleration: the surface leans by a/g, and the walls carry all of the
// liquid, at half its depth.
TEST(TankResponse, LeansUnderEvenAcceleration) {
  double const a = 0.2;
  GroundRecord const record = record_of(60.0, 0.01, [&](double t) {
    return t < 40.0 ? a * 0.5 * (1 - std::cos(std::numbers::pi * t / 40.0)) : a;
  });
  TankResponse const r = tank_response(tank, record, {.damping = 0.05, .modes = 4000});
  double const m = tank.mass();
  EXPECT_NEAR(r.surface.back(), -a / 9.81 * 1.0, 1e-3 * a / 9.81);
  EXPECT_NEAR(r.force.back(), -m * a, 1e-4 * m * a);
  EXPECT_NEAR(r.wall_moment.back(), -m * a * 0.5, 1e-4 * m * a);
  EXPECT_NEAR(r.turning_moment.back(), -m * a * (0.5 + 4.0 / 12.0), 1e-4 * m * a);
}

// A sudden jerk moves the impulsive mass alone.
TEST(TankResponse, BeginsWithTheImpulsiveMass) {
  GroundRecord const record = record_of(0.1, 0.001, [](double) { return 3.0; });
  TankResponse const r = tank_response(tank, record, {.damping = 0.0, .modes = 2000});
  ImpulsiveMass const impulsive = impulsive_mass(tank);
  double const force = impulsive.mass * 3.0;
  EXPECT_NEAR(r.force[0], -force, 1e-6 * force);
  EXPECT_NEAR(r.wall_moment[0], -force * impulsive.height.walls, 1e-6 * force);
  EXPECT_NEAR(r.turning_moment[0], -force * impulsive.height.walls_and_floor, 1e-6 * force);
}

// After the record the first mode swings on with its own period and its damping.
TEST(TankResponse, SwingsOnFreely) {
  SloshingMode const mode = sloshing_mode(tank, 1);
  GroundRecord const record = record_of(5.0, 0.005, [&](double t) {
    return std::sin(mode.angular_frequency * t) * std::sin(std::numbers::pi * t / 5.0);
  });
  TankResponse const r = tank_response(tank, record, {0.005, 1, 40.0});
  EXPECT_EQ(r.ground.size(), record.size() + 8000);
  std::vector<double> crossings;
  for (std::size_t i = record.size(); i < r.surface.size(); ++i)
    if (r.surface[i - 1] < 0.0 && r.surface[i] >= 0.0)
      crossings.push_back(r.ground.time(i) -
                          0.005 * r.surface[i] / (r.surface[i] - r.surface[i - 1]));
  double const period =
      (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  EXPECT_NEAR(period, mode.period() / std::sqrt(1.0 - 0.005 * 0.005), 1e-5);
}

// Linear: the sum of two motions gives the sum of the answers; a mirrored one the mirrored answer.
TEST(TankResponse, IsLinear) {
  GroundRecord a{"", 0.01, 0.0, white_noise(1000, 1)}, b{"", 0.01, 0.0, white_noise(1000, 2)};
  GroundRecord sum = a;
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum.acceleration[i] = 2.0 * a.acceleration[i] - b.acceleration[i];
  TankResponse const r_a = tank_response(tank, a, {}), r_b = tank_response(tank, b, {}),
                     r = tank_response(tank, sum, {});
  for (std::size_t i = 0; i < sum.size(); i += 13) {
    EXPECT_NEAR(r.surface[i], 2.0 * r_a.surface[i] - r_b.surface[i], 1e-12);
    EXPECT_NEAR(r.force[i], 2.0 * r_a.force[i] - r_b.force[i], 1e-9 * tank.mass());
  }
}

TEST(TankResponse, RefusesBadSettings) {
  GroundRecord const record = sine_record(1.0, 1.0, 2.0, 0.01);
  EXPECT_EQ(message_of<std::invalid_argument>([&] {
              tank_response(tank, record, {0.005, 0});
            }),
            "tank response: the number of modes must be 1 to 10000");
  EXPECT_EQ(message_of<std::invalid_argument>([&] {
              tank_response(tank, record, {1.5, 3});
            }),
            "oscillator: the damping ratio must be at least 0 and below 1");
  EXPECT_EQ(message_of<std::invalid_argument>([&] {
              tank_response(tank, record, {0.1, 3, -1.0});
            }),
            "tank response: the free time must be positive, at most 1e7 steps");
}

}  // namespace
}  // namespace moraine
