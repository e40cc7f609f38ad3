// The gas bubble of a charge under water (3D only: a line of gas has no bubble period).
#pragma once

namespace moraine::blast {

/// Water around the charge.
struct Water {
  double density = 1000.0;             // kg/m^3
  double gravity = 9.81;               // m/s^2
  double surface_pressure = 101325.0;  // Pa

  double pressure(double depth) const { return surface_pressure + density * gravity * depth; }
};

/// Largest radius of the first pulsation of a charge of TNT [m]:
///   a_m = 3.50 (W/(d + 10))^(1/3), W [kg], d depth [m], air above the water at sea level
/// Source: Swisdak (1978), as in underwater.hpp.
double bubble_radius(double charge_mass, double depth);

/// First period [s]: T = 2.11 W^(1/3)/(d + 10)^(5/6). Source: as above.
double bubble_period(double charge_mass, double depth);

/// Energy of the bubble [J]: Y = (4 pi/3) P_0 a_m^3, P_0 the pressure of the water at the charge.
double bubble_energy(double radius, double water_pressure);

/// First period [s] from the radius: T = 1.83 a_m sqrt(rho_0/P_0), which is 1.14 rho_0^(1/2)
/// Y^(1/3) P_0^(-5/6). An empty cavity in water without compressibility (Rayleigh, Phil. Mag. 34
/// (1917) 94): 1.83 is twice 0.91468. No surface, no bed, no gravity.
double rayleigh_period(double radius, double density, double water_pressure);

/// The same from the energy [J]. Source: H. F. Willis (1941), in Cole, Underwater Explosions
/// (1948), chapter 8.
double willis_period(double energy, double density, double water_pressure);

}  // namespace moraine::blast
