#include "verify/l1_errors.hpp"

#include <gtest/gtest.h>

#include "setup/build_model.hpp"
#include "verify/profile.hpp"
#include "verify/radial_flow.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

/// Sod's tube at rest, at 1 cm.
Simulation tube() {
  Case c = shipped_case("sod");
  c.numerics.spacing = 0.01;
  return Simulation(build_model(c));
}

FlowState start(double x) {
  return x < 0.0 ? FlowState{1.0, 0.0, 1.0, 2.5} : FlowState{0.125, 0.0, 0.1, 2.0};
}

TEST(L1Errors, AreRelativeToTheExactFlow) {
  Simulation const simulation = tube();
  L1Errors const none = l1_errors(simulation, FlowCoordinate::x, start);
  EXPECT_NEAR(none.density, 0.0, 1e-12);
  EXPECT_NEAR(none.pressure, 0.0, 1e-12);
  L1Errors const off = l1_errors(simulation, FlowCoordinate::x, [](double x) {
    FlowState state = start(x);
    state.density *= 1.25;
    state.velocity = 2.0;  // of gas that rests: all of it is missing
    return state;
  });
  EXPECT_NEAR(off.density, 0.2, 1e-12);
  EXPECT_NEAR(off.velocity, 1.0, 1e-12);
}

TEST(L1Errors, LeaveOutWhatIsNotCompared) {
  Simulation const simulation = tube();
  L1Errors const left =
      l1_errors(simulation, FlowCoordinate::x, [](double x) -> std::optional<FlowState> {
        if (x > 0.0) return std::nullopt;
        return FlowState{1.0, 0.0, 2.0, 0.0};
      });
  EXPECT_NEAR(left.density, 0.0, 1e-12);
  EXPECT_NEAR(left.pressure, 0.5, 1e-12);
}

TEST(L1Errors, OrdersAndLimits) {
  EXPECT_NEAR(convergence_order(4.0, 1.0), 2.0, 1e-12);
  EXPECT_NEAR(convergence_order(1.5, 1.0, 1.5), 1.0, 1e-12);
  EXPECT_NEAR(first_order_limit(1.2, 1.1), 1.0, 1e-12);
  EXPECT_NEAR(first_order_limit(1.3, 1.2, 1.5), 1.0, 1e-12);
}

TEST(Profile, MeansAndFronts) {
  Simulation const simulation = tube();
  EXPECT_NEAR(mean_between(simulation, Field::density, -0.3, -0.1), 1.0, 1e-12);
  EXPECT_NEAR(mean_between(simulation, Field::pressure, -0.2, 0.2), 0.55, 1e-12);
  EXPECT_NEAR(front_of_pressure(simulation, 0.5), -0.005, 1e-9);
}

/// A ball of gas with a hot core of 0.5 m.
TEST(RadialFlow, ShellsAndRadii) {
  Case c = about_origin(shipped_case("noh"), FlowGeometry::spherical, 1.0);
  c.numerics.spacing = 0.1;
  Model model = build_model(c);
  EXPECT_EQ(model.symmetry.copies(), 8);
  ParticleStore& store = model.particles;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    store.scalar(Field::specific_energy)[i] = distance_from_origin(store, i) < 0.5 ? 3.0 : 1.5;
  Simulation const simulation(std::move(model));
  EXPECT_NEAR(mean_in_shell(simulation, Field::pressure, 0.0, 0.4), 2.0, 1e-12);
  EXPECT_NEAR(mean_in_shell(simulation, Field::pressure, 0.6, 0.9), 1.0, 1e-12);
  EXPECT_NEAR(radius_of_pressure(simulation, 1.5, 0.1), 0.5, 0.05);
  EXPECT_EQ(radius_of_pressure(simulation, 5.0, 0.1), 0.0);
}

}  // namespace
}  // namespace moraine
