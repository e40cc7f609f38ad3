#include "blast/surface_burst.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "blast/free_air.hpp"
#include "blast/kingery_bulmash.hpp"
#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

// 8 lb at 10 ft: 0.054 * 4/10 lbf s/in^2.
TEST(SurfaceBurst, ImpulseOfTheFormula) {
  EXPECT_NEAR(surface_impulse(8.0 * pound, 10.0 * foot, usual_impulse_factor), 0.0216 * psi, 1e-9);
}

// A bare charge: the impulse of Kingery-Bulmash at middle distances, within 15 %.
TEST(SurfaceBurst, BareChargeAgreesWithKingeryBulmash) {
  for (double const z : {8.0, 10.0, 15.0, 25.0}) {  // ft/lb^(1/3)
    double const w = 20.0, r = z * foot_per_pound * std::cbrt(w);
    double const measured = std::cbrt(w) * kingery_impulse(Burst::surface, z * foot_per_pound);
    EXPECT_NEAR(surface_impulse(w, r, bare_charge_impulse_factor), measured, 0.15 * measured) << z;
  }
}

// The ground adds 70 to 100 % to the charge: the hemispherical peaks lie between the spherical ones
// of 1.5 W and 2.1 W from Z = 1.5 to 15.
TEST(SurfaceBurst, GroundEnlargesTheCharge) {
  for (double z = 1.5; z < 15.0; z *= 1.2) {
    double const surface = kingery_overpressure(Burst::surface, z);
    EXPECT_GT(surface, kingery_overpressure(Burst::free_air, z / std::cbrt(1.5))) << z;
    EXPECT_LT(surface, kingery_overpressure(Burst::free_air, z / std::cbrt(2.1))) << z;
  }
}

TEST(SurfaceBurst, ContactImpulseBetweenItsLimits) {
  double const unit = pound_force / pound;  // lbf s/lb in m/s
  EXPECT_NEAR(contact_impulse(1.0, 1e-9, 1e-9, 1.0), (183.0 - 191.0 / 1.1) * unit, 1e-3);
  EXPECT_NEAR(contact_impulse(1.0, 1e9, 1e9, 1.0), 183.0 * unit, 1e-3);
  EXPECT_NEAR(contact_impulse(2.0 * pound, 0.3, 0.3, 0.3),
              2.0 * (183.0 - 191.0 / 2.1) * pound_force, 1e-9);
  double last = 0.0;
  for (double side = 0.01; side < 1.0; side *= 1.3) {
    EXPECT_GT(contact_impulse(1.0, side, 0.1, 0.1), last);
    last = contact_impulse(1.0, side, 0.1, 0.1);
  }
}

}  // namespace
}  // namespace moraine::blast
