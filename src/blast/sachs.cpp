#include "blast/sachs.hpp"

#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

constexpr Air sea_level{standard_pressure, standard_density};

}  // namespace

Situation at_sea_level(Situation const& situation) {
  Situation same = situation;
  same.charge_mass *= sea_level.pressure / situation.air.pressure;
  same.air = sea_level;
  return same;
}

double sachs_factor(Kind kind, Air const& air) {
  double const pressure = air.pressure / sea_level.pressure;
  double const speed = air.sound_speed() / sea_level.sound_speed();
  switch (kind) {
    case Kind::pressure:
      return pressure;
    case Kind::impulse:
      return pressure / speed;
    case Kind::time:
      return 1.0 / speed;
    case Kind::speed:
      return speed;
    default:
      return 1.0;
  }
}

}  // namespace moraine::blast
