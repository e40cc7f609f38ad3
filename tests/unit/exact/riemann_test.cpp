#include "exact/riemann.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "exact/riemann_ideal_gas.hpp"

namespace moraine {
namespace {

RiemannSide gas_side(GasState const& gas, double gamma = 1.4) {
  IdealGas law;
  law.heat_capacity_ratio = gamma;
  return {law, gas.density, gas.velocity, gas.pressure / ((gamma - 1.0) * gas.density)};
}

struct Pair {
  GasState left;
  GasState right;
  double gamma;
};

// Sod, Toro's five problems, and gases from soft to stiff: two shocks, two rarefactions, both.
std::vector<Pair> const pairs{
    {{1, 0, 1}, {0.125, 0, 0.1}, 1.4},
    {{1, -2, 0.4}, {1, 2, 0.4}, 1.4},
    {{1, 0, 1000}, {1, 0, 0.01}, 1.4},
    {{1, 0, 0.01}, {1, 0, 100}, 1.4},
    {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.095}, 1.4},
    {{1, 3, 1}, {2, -1, 0.5}, 1.1},
    {{1, 0, 1e5}, {1000, 0, 1e5}, 5.0 / 3.0},
    {{3, 0.5, 7}, {2, 0.4, 9}, 7.0},
};

TEST(RiemannProblem, IsTheClosedFormForIdealGases) {
  double worst = 0.0;
  for (auto const& [left, right, gamma] : pairs) {
    RiemannIdealGas const closed(left, right, gamma);
    RiemannProblem const general(gas_side(left, gamma), gas_side(right, gamma));
    auto const check = [&](double a, double b, double size, char const* what) {
      worst = std::max(worst, std::fabs(a - b) / size);
      EXPECT_NEAR(a, b, 1e-9 * size) << what << " gamma " << gamma << " p " << left.pressure;
    };
    check(general.star_pressure(), closed.star_pressure(), closed.star_pressure(), "p*");
    double const c = std::sqrt(gamma * std::max(left.pressure / left.density,
                                                right.pressure / right.density));
    check(general.star_velocity(), closed.star_velocity(), c, "u*");
    double const low = general.left_wave().head - 0.1 * c;
    double const high = general.right_wave()->head + 0.1 * c;
    for (int k = 0; k <= 97; ++k) {
      double const s = low + (high - low) * k / 97.0;
      FlowState const a = general.sample(s);
      FlowState const b = closed.sample(s);
      check(a.density, b.density, b.density, "rho");
      check(a.velocity, b.velocity, c, "u");
      check(a.pressure, b.pressure, b.pressure, "p");
      check(a.specific_energy, b.specific_energy, b.specific_energy, "e");
    }
  }
  RecordProperty("worst", std::to_string(worst));
  std::printf("worst %g\n", worst);
}

}  // namespace
}  // namespace moraine
