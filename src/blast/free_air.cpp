#include "blast/free_air.hpp"

#include <cmath>

#include "base/power.hpp"
#include "blast/scales.hpp"

namespace moraine::blast {
namespace {

/// 1 + (z/scale)^exponent.
double term(double z, double scale, double exponent) { return 1.0 + power(z / scale, exponent); }

}  // namespace

double kinney_graham_overpressure(double scaled_distance, double ambient_pressure) {
  double const z = scaled_distance;
  return ambient_pressure * 808.0 * term(z, 4.5, 2.0) /
         std::sqrt(term(z, 0.048, 2.0) * term(z, 0.32, 2.0) * term(z, 1.35, 2.0));
}

double kinney_graham_duration(double scaled_distance) {
  double const z = scaled_distance;
  return 1e-3 * 980.0 * term(z, 0.54, 10.0) /
         (term(z, 0.02, 3.0) * term(z, 0.74, 6.0) * std::sqrt(term(z, 6.9, 2.0)));
}

double brode_overpressure(double scaled_distance) {
  double const x = 1.0 / scaled_distance;
  double const near = 6.7 * x * x * x + 1.0;
  if (near >= 10.0) return bar * near;
  return bar * (((5.85 * x + 1.455) * x + 0.975) * x - 0.019);
}

double henrych_overpressure(double scaled_distance) {
  double const x = 1.0 / scaled_distance;
  if (scaled_distance <= 0.3)
    return kilopond_per_cm2 * (((0.00625 * x - 0.3572) * x + 5.5397) * x + 14.0717) * x;
  if (scaled_distance <= 1.0) return kilopond_per_cm2 * ((2.1324 * x - 0.3262) * x + 6.1938) * x;
  return kilopond_per_cm2 * ((3.288 * x + 4.05) * x + 0.662) * x;
}

double three_term_overpressure(double scaled_distance) {
  return shape_fit_overpressure({4120.0, -105.0, 39.5}, scaled_distance);
}

double shape_fit_overpressure(ShapeFit const& fit, double scaled_distance) {
  double const x = foot_per_pound / scaled_distance;
  return psi * ((fit.cubic * x + fit.quadratic) * x + fit.linear) * x;
}

}  // namespace moraine::blast
