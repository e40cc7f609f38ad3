// How far pressure crushes the pores of a material that it loads for the first time.
#pragma once

#include <cmath>

#include "base/macros.hpp"

namespace moraine {

/// Distension of porous material under a pressure that it has never borne before.
///
///   alpha(p) = 1 + (alpha_e - 1) x^n,   x = (1 - q / P) / (1 + q / p_h),
///   q = p - p_e,   P = p_s - p_e
///
///   alpha = alpha_e for p <= p_e,   alpha = 1 for p >= p_s
///
/// Source: Herrmann, J. Appl. Phys. 40 (1969) 2490, for n = 2 and p_h infinite.
/// Symbols: alpha_e distension at the elastic limit, p_e elastic_limit, p_s
/// full_compaction_pressure, n exponent, p_h half_pressure.
/// Range: alpha_e > 1, 0 <= p_e < p_s, n >= 1, p_h > 0.
/// Departure: p_h is ours. Grains of sand rearrange at first and break later, so that the curve of
/// a sand has a long tail that no power gives; with n = 1 half of the pores are gone about p_h
/// above the elastic limit.
struct CrushCurve {
  double distension;                // -, alpha_e
  double elastic_limit;             // Pa, p_e
  double full_compaction_pressure;  // Pa, p_s
  double exponent;                  // -, n
  double half_pressure;             // Pa, p_h

  MORAINE_HD double distension_at(double p) const { return at(p).distension; }

  /// A place on the curve.
  struct Point {
    double distension;  // -
    double slope;  // 1/Pa, d(alpha)/dp towards larger p: not positive, zero outside of the range
  };

  MORAINE_HD Point at(double p) const {
    double const q = p - elastic_limit;
    if (q < 0.0) return {distension, 0.0};
    if (!(q < span())) return {1.0, 0.0};
    double const softer = 1.0 / (1.0 + q / half_pressure);
    double const x = (1.0 - q / span()) * softer;
    double const by_pressure = -(1.0 / span() + 1.0 / half_pressure) * softer * softer;
    double const scale = (distension - 1.0) * power(x, exponent - 1.0);
    return {1.0 + scale * x, scale * exponent * by_pressure};
  }

  /// The pressure that crushes down to `alpha`: p_e from alpha_e on, p_s down to 1.
  MORAINE_HD double pressure_at(double alpha) const {
    if (!(alpha < distension)) return elastic_limit;
    if (!(alpha > 1.0)) return full_compaction_pressure;
    double const x = power((alpha - 1.0) / (distension - 1.0), 1.0 / exponent);
    return elastic_limit + span() * (1.0 - x) / (1.0 + x * span() / half_pressure);
  }

 private:
  MORAINE_HD double span() const { return full_compaction_pressure - elastic_limit; }

  // The usual powers need no logarithm.
  MORAINE_HD static double power(double x, double of) {
    if (of == 1.0) return x;
    if (of == 0.0) return 1.0;
    return of == 0.5 ? std::sqrt(x) : std::pow(x, of);
  }
};

}  // namespace moraine
