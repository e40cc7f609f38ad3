// Linear theory of the liquid in a rigid rectangular tank.
#pragma once

#include "base/gravity.hpp"

namespace moraine {

/// A rectangular tank with vertical walls, open above, seen along the motion.
struct RigidTank {
  double length = 0.0;                // m, clear inside, along the motion
  double depth = 0.0;                 // m, of the liquid
  double width = 1.0;                 // m, across the motion; 1: everything per metre
  double density = 1000.0;            // kg/m^3
  double gravity = standard_gravity;  // m/s^2

  double mass() const { return density * length * depth * width; }  // kg
};

/// Throws std::invalid_argument unless all of these are positive and finite, and length and depth
/// within a factor of 10 000 of each other.
void check_tank(RigidTank const& tank);

/// How high above the floor a horizontal force acts [m]: with the pressure on the walls alone (for
/// the bending of walls), or with that on the floor too (for what turns the tank over).
struct ForceHeight {
  double walls = 0.0;
  double walls_and_floor = 0.0;
};

/// One mode of the surface, cos(n pi x / L), in an ideal liquid:
///   w_n^2 = g k tanh(k d),   k = n pi / L
/// and, for odd n, which horizontal motion drives, its mass and where its force acts,
///   m_n / m = 8 tanh(k d) / ((n pi)^3 d/L),
///   h_n = d - tanh(k d/2) / k,   h_n' = d - (cosh(k d) - 2) / (k sinh(k d)),
/// h' counting the floor. A mass on a spring that replaces the mode hangs at the lower height
///   d - 2 tanh(k d/2) / k = h_n' - g / w_n^2,
/// since its own weight turns over too. Even modes have no mass. Ibrahim, Liquid Sloshing Dynamics
/// (2005), chapters 1 and 5; Graham & Rodriguez, J. Appl. Mech. 19 (1952) 381.
struct SloshingMode {
  int number = 0;                  // n, half waves along the tank
  double wave_number = 0.0;        // k, 1/m
  double angular_frequency = 0.0;  // rad/s
  double mass = 0.0;               // kg
  ForceHeight height;              // m
  double spring_height = 0.0;      // m, of the mass on a spring

  double frequency() const;  // Hz
  double period() const;     // s
};

/// The mode n >= 1. Throws std::invalid_argument for a bad tank or number.
SloshingMode sloshing_mode(RigidTank const& tank, int number);

/// What moves with the tank: m_0 = m - sum m_n and, from the moments of all of the liquid,
///   m_0 h_0 = m d/2 - sum m_n h_n,   m_0 h_0' = m (d/2 + L^2/(12 d)) - sum m_n h_n',
/// since liquid that moves as a whole presses on the walls evenly over the height and on the floor
/// in proportion to x. The sums reach to infinity, within 1e-9 of the total.
struct ImpulsiveMass {
  double mass = 0.0;   // kg
  ForceHeight height;  // m
};

ImpulsiveMass impulsive_mass(RigidTank const& tank);

/// Housner's approximation, as in ACI 350.3-06, section 9.2:
///   m_i / m = tanh(x)/x, x = (sqrt(3)/2) L/d;   m_c / m = 0.264 (L/d) tanh(3.16 d/L);
///   w_c^2 = 3.16 (g/L) tanh(3.16 d/L)
/// The impulsive mass is up to 11 % above that of linear theory (at L = 0.95 d).
struct HousnerTank {
  ImpulsiveMass impulsive;
  double convective_mass = 0.0;               // kg
  ForceHeight convective_height;              // m
  double convective_angular_frequency = 0.0;  // rad/s
};

HousnerTank housner_tank(RigidTank const& tank);

}  // namespace moraine
