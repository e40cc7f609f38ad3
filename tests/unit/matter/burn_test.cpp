// Programmed burn of a particle, and where it is lit.
#include "matter/burn/burn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "matter/eos/eos.hpp"

namespace moraine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ProgrammedBurn tnt_burn{6930.0, 0.7318, 1.5e-4, 1630.0};

TEST(ProgrammedBurn, RisesBehindTheFront) {
  double const crossing = 1.5e-4 / 6930.0;
  EXPECT_EQ(tnt_burn.fraction(0.0, 1630.0, -infinity), 0.0);
  EXPECT_EQ(tnt_burn.fraction(0.0, 1630.0, -1e-9), 0.0);
  EXPECT_NEAR(tnt_burn.fraction(0.0, 1630.0, 0.25 * crossing), 0.25, 1e-12);
  EXPECT_EQ(tnt_burn.fraction(0.0, 1630.0, 3.0 * crossing), 1.0);
}

TEST(ProgrammedBurn, BurnsWhatIsCompressed) {
  EXPECT_NEAR(tnt_burn.fraction(0.0, 1630.0 / 0.7318, -infinity), 1.0, 1e-12);
  EXPECT_NEAR(tnt_burn.fraction(0.0, 1630.0 / 0.8659, -infinity), 0.5, 1e-12);
  EXPECT_EQ(tnt_burn.fraction(0.0, 1600.0, -infinity), 0.0);
}

// Squeezed and let go again by a little, many times: nothing burns that is not lit.
TEST(ProgrammedBurn, GoesBackWithTheCompressionBeforeItIsLit) {
  double before = 0.0;
  for (int k = 0; k < 1000; ++k) {
    double const rho = 1630.0 * (1.0 + 0.01 * std::sin(0.37 * k));
    before = tnt_burn.fraction(before, rho, -1.0);
    EXPECT_NEAR(before, std::max(0.0, tnt_burn.by_compression(rho)), 1e-15);
  }
}

TEST(ProgrammedBurn, StaysBurntWhereCompressionHasBurntAll) {
  double const all = tnt_burn.fraction(0.0, 1630.0 / 0.73, -infinity);
  EXPECT_EQ(all, 1.0);
  EXPECT_EQ(tnt_burn.fraction(all, 1000.0, -infinity), 1.0);
}

TEST(ProgrammedBurn, NeverFallsOnceItIsLit) {
  double before = 0.0;
  for (int k = 0; k < 1000; ++k) {
    double const rho = 1630.0 * (1.0 + 0.3 * std::sin(0.37 * k));
    double const now = tnt_burn.fraction(before, rho, 3e-11 * k);
    EXPECT_GE(now, before);
    EXPECT_LE(now, 1.0);
    before = now;
  }
  EXPECT_EQ(before, 1.0);
}

TEST(ProgrammedBurn, GivesItsShareOfThePressure) {
  Jwl const products{};
  EXPECT_EQ(tnt_burn.respond(products, 1600.0, 4.29e6, 0.0).pressure, 0.0);
  EXPECT_EQ(tnt_burn.respond(products, 1600.0, 4.29e6, 0.0).sound_speed, 0.0);
  EXPECT_DOUBLE_EQ(tnt_burn.respond(products, 1600.0, 4.29e6, 0.3).pressure,
                   0.3 * products.pressure(1600.0, 4.29e6));
  StateResponse const burnt = tnt_burn.respond(products, 2200.0, 4e6, 1.0);
  EXPECT_EQ(burnt.pressure, products.respond(2200.0, 4e6).pressure);
  EXPECT_EQ(burnt.sound_speed, products.respond(2200.0, 4e6).sound_speed);
}

// c^2 = dp/drho along an adiabat, de = p / rho^2 drho, by central differences; F held where it is
// above what compression burns, and rising with the compression where it is that.
template <class Products>
void expect_sound_speed(Products const& products, double rho, double e, double fraction,
                        bool by_compression) {
  double const step = 1e-6 * rho;
  StateResponse const here = tnt_burn.respond(products, rho, e, fraction);
  auto const pressure = [&](double change) {
    double const f = by_compression ? tnt_burn.by_compression(rho + change) : fraction;
    double const energy = e + here.pressure / (rho * rho) * change;
    return f * products.pressure(rho + change, energy);
  };
  double const expected = (pressure(step) - pressure(-step)) / (2.0 * step);
  EXPECT_NEAR(here.sound_speed * here.sound_speed, expected, 1e-6 * expected)
      << products.name << " rho " << rho << ", F " << fraction;
}

TEST(ProgrammedBurn, SoundSpeedIsThatOfTheShare) {
  IdealGas const gas{1630.0, 2.7, 4.29e6};
  for (double const rho : {1200.0, 1630.0, 1800.0})
    for (double const fraction : {0.05, 0.5, 0.95}) {
      bool const compressed = tnt_burn.by_compression(rho) > fraction;
      if (compressed) continue;  // it would have burnt further
      expect_sound_speed(Jwl{}, rho, 4.29e6, fraction, false);
      expect_sound_speed(gas, rho, 4.29e6, fraction, false);
    }
  for (double const rho : {1640.0, 1800.0, 2100.0}) {
    expect_sound_speed(Jwl{}, rho, 4.4e6, tnt_burn.by_compression(rho), true);
    expect_sound_speed(gas, rho, 4.4e6, tnt_burn.by_compression(rho), true);
  }
}

TEST(Products, AreJwlAndIdealGas) {
  EXPECT_TRUE(can_burn(Jwl{}));
  EXPECT_TRUE(can_burn(IdealGas{}));
  for (Eos const& eos : {Eos(Tait{}), Eos(WaterPolynomial{}), Eos(MieGrueneisen{}), Eos(UsUp{}),
                         Eos(Linear{}), Eos(PAlpha{})})
    EXPECT_FALSE(can_burn(eos)) << eos_name(eos);
}

TEST(Ignition, IsAsFarAsTheNearestPlace) {
  Ignition ignition;
  EXPECT_FALSE(ignition.any());
  EXPECT_EQ(ignition.distance({1.0, 2.0, 3.0}), infinity);
  ignition.points = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}};
  EXPECT_DOUBLE_EQ(ignition.distance({3.0, 4.0, 0.0}), 5.0);
  EXPECT_DOUBLE_EQ(ignition.distance({10.0, 0.0, 2.0}), 2.0);
  ignition.line = Ignition::Line{{0.0, 5.0, 0.0}, {10.0, 5.0, 0.0}};
  EXPECT_DOUBLE_EQ(ignition.distance({3.0, 4.0, 0.0}), 1.0);
  EXPECT_DOUBLE_EQ(ignition.distance({14.0, 8.0, 0.0}), 5.0) << "beyond the end of the line";
  ignition.plane = Ignition::Plane{{0.0, 0.0, 20.0}, {0.0, 0.0, -3.0}};
  EXPECT_DOUBLE_EQ(ignition.distance({14.0, 8.0, 19.0}), 1.0);
  EXPECT_DOUBLE_EQ(ignition.distance({14.0, 8.0, 22.0}), 2.0);
  Ignition spot;
  spot.line = Ignition::Line{{1.0, 1.0, 0.0}, {1.0, 1.0, 0.0}};
  EXPECT_DOUBLE_EQ(spot.distance({1.0, 3.0, 0.0}), 2.0) << "a line without length is a point";
}

}  // namespace
}  // namespace moraine
