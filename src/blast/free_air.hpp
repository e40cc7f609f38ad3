// Spherical charges of TNT in free air: closed formulas for the peak and the duration.
#pragma once

namespace moraine::blast {

/// Peak overpressure [Pa]:
///   p/p_a = 808 [1 + (Z/4.5)^2] / sqrt{[1 + (Z/0.048)^2] [1 + (Z/0.32)^2] [1 + (Z/1.35)^2]}
/// Source: G. F. Kinney, K. J. Graham, Explosive Shocks in Air, 2nd ed. (1985), chapter 6.
/// Z [m/kg^(1/3)], p_a ambient pressure [Pa].
double kinney_graham_overpressure(double scaled_distance, double ambient_pressure);

/// Duration of the positive phase [s/kg^(1/3)]:
///   t/W^(1/3) = 980 [1 + (Z/0.54)^10] / {[1 + (Z/0.02)^3] [1 + (Z/0.74)^6] sqrt[1 + (Z/6.9)^2]} ms
/// Source: as above.
double kinney_graham_duration(double scaled_distance);

/// Peak overpressure [Pa], p in bar and Z in m/kg^(1/3):
///   p = 6.7/Z^3 + 1 where that is above 10,
///   p = 0.975/Z + 1.455/Z^2 + 5.85/Z^3 - 0.019 for p of 0.1 to 10.
/// Source: H. L. Brode, J. Appl. Phys. 26 (1955) 766. Between Z = 0.906, where the first falls to
/// 10 bar, and 0.930, where the second does, neither is in its range: the second one is returned,
/// above 10 bar. Below 0.1 bar it goes on, to a negative value far out.
double brode_overpressure(double scaled_distance);

/// Peak overpressure [Pa], p in kgf/cm^2 and Z in m/kg^(1/3):
///   14.0717/Z + 5.5397/Z^2 - 0.3572/Z^3 + 0.00625/Z^4  for 0.05 <= Z <= 0.3,
///   6.1938/Z - 0.3262/Z^2 + 2.1324/Z^3                 for 0.3 < Z <= 1,
///   0.662/Z + 4.05/Z^2 + 3.288/Z^3                     for 1 < Z <= 10.
/// Source: J. Henrych, The Dynamics of Explosion and its Use (1979), chapter 4. Outside, the
/// nearest piece goes on.
double henrych_overpressure(double scaled_distance);

/// Peak overpressure [Pa], p in psi and Z in ft/lb^(1/3):
///   p = 4120/Z^3 - 105/Z^2 + 39.5/Z  for 3 <= Z <= 20 (2 to 160 psi).
/// Source: a 2017 doctoral thesis on explosions in granular soil with SPH, chapter 3.
double three_term_overpressure(double scaled_distance);

/// Charges whose shape was fitted: p = a/Z^3 + b/Z^2 + c/Z psi, Z in ft/lb^(1/3). As printed the
/// fits differ fivefold among each other and the signs of b are in doubt: for comparison with the
/// source only. Source: as above; it states no range.
struct ShapeFit {
  double cubic;      // psi ft^3/lb
  double quadratic;  // psi ft^2/lb^(2/3)
  double linear;     // psi ft/lb^(1/3)
};
inline constexpr ShapeFit tnt_block_1_lb{36280.0, -770.0, 13.5};
inline constexpr ShapeFit pentolite_cylinder_8_lb{21070.0, -135.0, 10.5};
inline constexpr ShapeFit tnt_cylinder_4_lb{19210.0, -186.0, 11.34};
inline constexpr ShapeFit pentolite_sphere_3_75_lb{7823.0, -295.0, 8.63};

/// Peak overpressure [Pa] of a fit at Z [m/kg^(1/3)].
double shape_fit_overpressure(ShapeFit const& fit, double scaled_distance);

}  // namespace moraine::blast
