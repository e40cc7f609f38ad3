// Charges on the ground.
#pragma once

namespace moraine::blast {

/// Rigid ground would double the charge; real ground takes part of it into a crater: free-air
/// relations hold for W times 1.7 to 2.
inline constexpr double least_ground_factor = 1.7;
inline constexpr double most_ground_factor = 2.0;

/// Impulse of the positive phase [Pa s]: I = K W^(2/3)/R, I in lbf s/in^2, W in lb, R in ft.
/// Source: a 2017 doctoral thesis on explosions in granular soil with SPH, chapter 3.
/// W [kg], R [m]; K as below. The source states no range.
double surface_impulse(double charge_mass, double distance, double k);
inline constexpr double usual_impulse_factor = 0.054;
inline constexpr double heavy_case_impulse_factor = 0.036;
inline constexpr double bare_charge_impulse_factor = 0.081;

/// Impulse that a charge on a target gives it in all [N s]:
///   I = W [183 - 191/(1.1 + sqrt(a b/d^2))] lbf s, W in lb
/// a, b sides of the face in contact, d height of the charge above it [m]. Source: as above; it
/// states no range. Rises with a b/d^2 from 9.4 to 183 lbf s/lb.
double contact_impulse(double charge_mass, double side_a, double side_b, double height);

}  // namespace moraine::blast
