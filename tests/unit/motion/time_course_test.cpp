// Prescribed courses and rigid motions against their exact derivatives.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "motion/rigid_motion.hpp"

namespace moraine {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

TEST(TimeCourse, FormulaHasItsDerivatives) {
  auto const course = TimeCourse::formula("0.05 * sin(2*pi*0.8*t)", 1e-3);
  double const w = two_pi * 0.8;
  // Differences of fourth order over d = 1 ms: d^4/30 f5 of the rate, d^4/90 f6 of the second, and
  // beside the start d^4/5 f5 and 5/6 d^3 f5; f5 = 0.05 w^5 = 160.
  for (double const t : {0.0, 1e-4, 0.1, 0.77, 12.0}) {
    CourseState const state = course.at(t);
    EXPECT_NEAR(state.value, 0.05 * std::sin(w * t), 1e-15);
    EXPECT_NEAR(state.rate, 0.05 * w * std::cos(w * t), t < 2e-3 ? 4e-11 : 1e-11);
    EXPECT_NEAR(state.second_rate, -0.05 * w * w * std::sin(w * t), t < 2e-3 ? 2e-7 : 1e-9);
  }
}

TEST(TimeCourse, FormulaIsNotAskedBeforeTheStart) {
  auto const course = TimeCourse::formula("t >= 0 ? sqrt(t + 1e-30) : log(-1)", 1e-6);
  EXPECT_TRUE(std::isfinite(course.at(0.0).rate));
}

TEST(TimeCourse, RefusesWhatIsNoFormula) {
  for (char const* text : {"", "0.05 * sin(", "x + 1", "t t", "1, 2"})
    EXPECT_THROW(TimeCourse::formula(text, 1e-3), std::invalid_argument) << text;
}

TEST(TimeCourse, TableIsASplineThroughItsValues) {
  std::vector<double> times, values;
  for (int k = 0; k <= 100; ++k) {
    times.push_back(0.01 * k);
    values.push_back(std::sin(two_pi * times.back()));  // bends nowhere at both ends
  }
  auto const course = TimeCourse::table(times, values);
  for (std::size_t k = 0; k < times.size() - 1; ++k)
    EXPECT_NEAR(course.at(times[k]).value, values[k], 1e-15);
  // Errors of a cubic spline: 5/384 l^4 f4 of the value, l^3/24 f4 of the rate, l^2/8 f4 of the
  // second derivative, with l = 0.01 and f4 = (2 pi)^4.
  for (double t = 0.003; t < 1.0; t += 0.0071) {
    CourseState const state = course.at(t);
    EXPECT_NEAR(state.value, std::sin(two_pi * t), 3e-7);
    EXPECT_NEAR(state.rate, two_pi * std::cos(two_pi * t), 7e-5);
    EXPECT_NEAR(state.second_rate, -two_pi * two_pi * std::sin(two_pi * t), 2e-2);
  }
  EXPECT_EQ(course.at(2.0).value, values.back());
  EXPECT_EQ(course.at(2.0).rate, 0.0);
  EXPECT_THROW(TimeCourse::table({0.0, 1.0, 1.0}, {0.0, 1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(TimeCourse::table({0.0}, {0.0}), std::invalid_argument);
}

TEST(RigidMotion, VelocityAndAccelerationAreThoseOfItsPlaces) {
  RigidMotion motion;
  motion.translation = {TimeCourse::formula("0.3 * sin(t)", 1e-3),
                        TimeCourse::formula("0.1 * t^2", 1e-3), TimeCourse{}};
  motion.rotation = TimeCourse::formula("0.5 * t^2", 1e-3);
  motion.about = {0.2, -0.1, 0.4};
  motion.axis = {0.6, 0.0, 0.8};
  Vec3 const x_0{1.0, 0.5, -0.3};
  double const t = 0.9, d = 1e-4;
  auto const place = [&](double time) { return motion.at(time).place(x_0); };
  Vec3 const x = place(t);
  Vec3 const velocity = motion.at(t).velocity(x);
  Vec3 const acceleration = motion.at(t).acceleration(x);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(velocity[k], (place(t + d)[k] - place(t - d)[k]) / (2.0 * d), 1e-7);
    EXPECT_NEAR(acceleration[k], (place(t + d)[k] - 2.0 * x[k] + place(t - d)[k]) / (d * d), 1e-6);
  }
  // Rigid: distances and the normals' length stay.
  Vec3 const other{-0.4, 0.2, 0.9};
  EXPECT_NEAR(norm(subtract(x, motion.at(t).place(other))), norm(subtract(x_0, other)), 1e-14);
  EXPECT_NEAR(norm(motion.at(t).turned({0.0, 1.0, 0.0})), 1.0, 1e-14);
  EXPECT_LE(norm(velocity), motion.at(t).largest_speed(norm(subtract(x_0, motion.about))));
  EXPECT_LE(norm(acceleration),
            motion.at(t).largest_acceleration(norm(subtract(x_0, motion.about))));
}

}  // namespace
}  // namespace moraine
