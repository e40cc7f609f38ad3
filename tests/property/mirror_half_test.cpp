// A quarter of a charge between mirrors against the whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "support/charge_in_box.hpp"

namespace moraine {
namespace {

using charge::charge_in_box;
using charge::spacing;

using State = std::array<double, 7>;

std::vector<State> states(Simulation const& simulation) {
  ParticleStore const& store = simulation.particles();
  std::vector<State> all(store.range(Kind::fluid).size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (int axis = 0; axis < store.dimension(); ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      all[i][k] = store.component(Field::position, axis)[i] / spacing;
      all[i][3 + k] = store.component(Field::velocity, axis)[i] / 1000.0;
    }
    all[i][6] = store.scalar(Field::density)[i] / 1000.0;
  }
  return all;
}

// A quarter of a charge between two free-slip mirrors does what it does in the whole.
TEST(MirrorWall, FreeSlipHalvesDoWhatTheWholeDoes) {
  for (int const dimension : {1, 2, 3}) {
    int const side = dimension == 1 ? 80 : (dimension == 2 ? 40 : 20);
    double const half = 0.5 * side * spacing;
    Case whole = charge_in_box(dimension, side, WallMethod::dummy, Slip::free);
    Box box{};
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      box.min[axis] = -half;
      box.max[axis] = half;
      whole.domain.min[axis] = -2.0 * half;
      whole.domain.max[axis] = 2.0 * half;
    }
    whole.regions = {{"sea", "water", box, {}}, {"charge", "tnt", Disc{{}, 0.3 * half}, {}}};
    whole.walls[0].box = box;
    Case part = whole;
    WallSpec mirror = part.walls[0];
    mirror.name = "mirror";
    mirror.method = WallMethod::mirror;
    mirror.box.min = {};
    for (std::size_t axis = 0; axis < 3; ++axis) mirror.open[axis][1] = true;
    part.walls.push_back(mirror);
    end_domain_at_mirrors(part);
    Simulation a(build_model(part)), b(build_model(whole));
    for (int step = 0; step < 60; ++step) {
      a.advance();
      b.advance();
    }
    ASSERT_NEAR(a.sums().mass * std::pow(2.0, dimension) / b.sums().mass, 1.0, 1e-12);
    auto const all = states(b);
    double worst = 0.0;
    for (State const& state : states(a)) {
      double nearest = 1e30;
      for (State const& other : all) {
        double difference = 0.0;
        for (std::size_t k = 0; k < state.size(); ++k)
          difference = std::max(difference, std::fabs(state[k] - other[k]));
        nearest = std::min(nearest, difference);
      }
      worst = std::max(worst, nearest);
    }
    EXPECT_LE(worst, 1e-9) << dimension;  // rounding, grown over 60 steps of a violent flow
  }
}

}  // namespace
}  // namespace moraine
