// What an engineer knows about an explosion and a place, in SI units.
#pragma once

#include <limits>

#include "blast/bubble.hpp"
#include "blast/buried.hpp"
#include "blast/crater.hpp"
#include "blast/displacement.hpp"
#include "blast/front.hpp"
#include "blast/scales.hpp"

namespace moraine::blast {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Inputs of the relations; what is not known stays `unknown` or null. Lists in buried.hpp,
/// displacement.hpp and crater.hpp hold the kinds of ground.
struct Situation {
  double charge_mass = unknown;   // kg of TNT
  double explosive_factor = 1.0;  // on pressures and impulses
  double distance = unknown;      // m, from the centre or axis of the charge
  Air air{standard_pressure, standard_density};
  double ground_factor = 1.8;     // charge at the ground over charge in free air
  double overpressure = unknown;  // Pa, of an incident front or a pulse
  double angle = unknown;         // rad, between front and wall
  double duration = unknown;      // s, of a positive phase
  double decay = unknown;         // of Friedlander's history
  double time = unknown;          // s, since the arrival
  double length = unknown;        // m, of a line charge
  double side_a = unknown;        // m, sides and height of a charge in contact
  double side_b = unknown;
  double height = unknown;
  double depth = unknown;          // m, of the charge below ground or water level
  double coupling = unknown;       // of a buried charge to the ground
  double depth_factor = unknown;   // of Lampson's crater
  double bubble_energy = unknown;  // J
  Soil const* soil = nullptr;
  DisplacedGround const* displaced = nullptr;
  BrokenGround const* broken = nullptr;
  Water water;

  /// R/W^(1/3) [m/kg^(1/3)].
  double scaled_distance() const;
  /// The same in ft/lb^(1/3).
  double scaled_distance_imperial() const { return scaled_distance() / foot_per_pound; }
  /// W^(1/3) [kg^(1/3)].
  double size() const;
  bool air_is_standard() const {
    return air.pressure == standard_pressure && air.density == standard_density;
  }
};

}  // namespace moraine::blast
