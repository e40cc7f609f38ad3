// Porous compaction, p-alpha: a solid whose pores are crushed by pressure and do not open again.
#pragma once

#include <cmath>
#include <limits>

#include "base/increasing_root.hpp"
#include "base/macros.hpp"
#include "matter/eos/crush_curve.hpp"
#include "matter/eos/state_response.hpp"
#include "matter/eos/us_up.hpp"

namespace moraine {

/// What material answers that may be compacted while it is loaded.
struct CompactionResponse {
  double pressure;                 // Pa
  double sound_speed_squared;      // m^2/s^2, slope of the branch; negative where there is none
  double distension;               // -, the least that has been reached, this state included
  double unloading_speed_squared;  // m^2/s^2, of the elastic line: at least sound_speed_squared
};

/// Porous material by the distension alpha, density of its solid over that of the whole.
///
///   p = p_solid(alpha rho, e) / alpha
///
/// with p_solid of Mie and Grueneisen about a straight shock line (matter/eos/us_up.hpp).
///
///   first loading from p_e on:  alpha = alpha(p) of the crush curve (matter/eos/crush_curve.hpp)
///   below the largest p so far: 1/alpha = 1/alpha* - (p* - p) (1/h^2 - 1) / K
///   h = 1 - (1 - c_e / C) (alpha* - 1) / (alpha_e - 1),   K = rho_s C^2
///
/// (p*, alpha*) is where the crush curve was left: alpha* is the least distension reached, the one
/// thing that a particle must remember, and p* the pressure of the curve there. Loading again
/// follows the same line back to that point. So compaction is reversible nowhere but below p_e, a
/// closed cycle loses energy or returns it all, and tension opens no pore.
///
///   c^2 = c_solid^2 / (1 + b' (rho_solid dp_solid/drho_solid - p_solid)),   b' = d(1/alpha)/dp
///
/// of the branch that the state is on; exactly dp/drho + (p / rho^2) dp/de. Where pores are being
/// crushed, what unloads runs at the speed of the elastic line that begins there, several times as
/// fast: unloading_speed_squared.
///
/// Sources: Herrmann, J. Appl. Phys. 40 (1969) 2490; the factor 1/alpha of Carroll and Holt, J.
/// Appl. Phys. 43 (1972) 759. The elastic line is Herrmann's, d(alpha)/dp = (alpha^2 / K)
/// (1 - 1/h^2), with h taken where the crush curve was left, which makes it a closed form.
/// Symbols: rho_0 reference_density and c_e reference_sound_speed of the undisturbed porous
/// material; rho_s solid_density, C solid_sound_speed, S hugoniot_slope, Gamma_0
/// grueneisen_coefficient of the solid; p_e elastic_limit, p_s full_compaction_pressure, n
/// crush_exponent, p_h half_pressure; p_min least_pressure. At rho_0 with e = 0: p = 0, alpha =
/// rho_s / rho_0, c = c_e.
/// Range: rho > 0, alpha rho below the limiting density of the solid; rho_0 < rho_s, c_e <= C,
/// p_min <= p_e. Gas in the pores bears nothing. The elastic line must be steeper than the crush
/// curve, else cycles would create energy (unloads_steeply).
/// Floor: p >= p_min; there c is frozen as in matter/eos/pressure_floor.hpp.
struct PAlpha {
  static constexpr char const* name = "p_alpha";

  double reference_density = 1674.0;                               // kg/m^3, rho_0
  double reference_sound_speed = 265.0;                            // m/s, c_e
  double solid_density = 2650.0;                                   // kg/m^3, rho_s
  double solid_sound_speed = 3680.0;                               // m/s, C
  double hugoniot_slope = 2.12;                                    // -, S
  double grueneisen_coefficient = 0.65;                            // -, Gamma_0
  double elastic_limit = 0.0;                                      // Pa, p_e
  double full_compaction_pressure = 75e6;                          // Pa, p_s
  double crush_exponent = 2.0;                                     // -, n
  double half_pressure = std::numeric_limits<double>::infinity();  // Pa, p_h
  double reference_energy = 0.0;                                   // J/kg
  double least_pressure = 0.0;                                     // Pa, p_min

  /// The compacted material, without a floor.
  MORAINE_HD UsUp solid() const {
    return {solid_density,          solid_sound_speed, hugoniot_slope,
            grueneisen_coefficient, reference_energy,  -std::numeric_limits<double>::infinity()};
  }

  /// K = rho_s C^2 [Pa].
  MORAINE_HD double stiffness() const {
    return solid_density * solid_sound_speed * solid_sound_speed;
  }

  MORAINE_HD double limiting_density() const { return solid().limiting_density(); }

  /// alpha_e: what particles remember before they have ever been compacted.
  MORAINE_HD double virgin_distension() const {
    double const by_pressure = elastic_slope(reference_sound_speed / solid_sound_speed);
    return 1.0 / (reference_density / solid_density + by_pressure * elastic_limit);
  }

  MORAINE_HD CrushCurve crush_curve() const {
    return {virgin_distension(), elastic_limit, full_compaction_pressure, crush_exponent,
            half_pressure};
  }

  /// State of material with density `rho` [kg/m^3] and energy `e` [J/kg] whose distension has been
  /// as small as `least`: values from virgin_distension() on mean that it is undisturbed.
  MORAINE_HD CompactionResponse respond(double rho, double e, double least) const {
    CrushCurve const curve = crush_curve();
    Line const line = elastic_line(curve, least);
    if (!(line.distension > 1.0)) return compact(rho, e);
    ValueAndSlope const top = excess(line.pressure, line.solid_part, line.slope, rho, e);
    // Rounding must not turn the state in which loading stopped into new loading.
    if (!(top.value < -rounding()))
      return on_line(line, line.pressure - top.value / top.slope, rho, e);
    if (!(excess(full_compaction_pressure, 1.0, 0.0, rho, e).value > 0.0)) return compact(rho, e);
    return on_curve(curve, line, rho, e);
  }

  /// The same of undisturbed material: loading for the first time.
  MORAINE_HD CompactionResponse virgin(double rho, double e) const {
    return respond(rho, e, virgin_distension());
  }

  MORAINE_HD double pressure(double rho, double e) const { return virgin(rho, e).pressure; }

  MORAINE_HD double sound_speed_squared(double rho, double e) const {
    return virgin(rho, e).sound_speed_squared;
  }

  MORAINE_HD double sound_speed(double rho, double e) const {
    return signed_root(sound_speed_squared(rho, e));
  }

  MORAINE_HD StateResponse respond(double rho, double e) const {
    CompactionResponse const response = virgin(rho, e);
    return {response.pressure, signed_root(response.sound_speed_squared)};
  }

  /// Density at which undisturbed material of energy `e` [J/kg] comes to pressure `p` [Pa]; NaN for
  /// p < p_min and where the solid has no such state.
  MORAINE_HD double density_at_pressure(double p, double e) const {
    if (!(p >= least_pressure)) return std::nan("");
    double const part = solid_part_of_virgin(p);
    return part * solid().density_at_pressure(p / part, e);
  }

  /// Energy of undisturbed material that has density `rho` [kg/m^3] and pressure `p` [Pa]; NaN
  /// where there is none, the reference energy where Gamma_0 = 0.
  MORAINE_HD double energy_at_pressure(double rho, double p) const {
    if (!(p >= least_pressure)) return std::nan("");
    double const part = solid_part_of_virgin(p);
    return solid().energy_at_pressure(rho / part, p / part);
  }

  /// Sound speed with which the crush curve begins, just above the elastic limit [m/s].
  MORAINE_HD double crush_speed() const {
    CrushCurve const curve = crush_curve();
    auto const [alpha, slope] = curve.at(elastic_limit);
    double const rho = density_at_pressure(elastic_limit, 0.0);
    return signed_root(sound_speed_squared_at(1.0 / alpha, -slope / (alpha * alpha), rho, 0.0));
  }

  /// The pressure below zero at which the elastic line of undisturbed material would leave it no
  /// solid [Pa]; nothing is calculated beyond.
  MORAINE_HD double largest_tension() const {
    Line const line = elastic_line(crush_curve(), virgin_distension());
    return line.pressure - line.solid_part / line.slope;
  }

  /// Whether at every stage of compaction the line of unloading is at least as steep as the crush
  /// curve that it leaves. Otherwise unloading would return more work than loading took.
  bool unloads_steeply() const;

 private:
  // The elastic line through a point of the crush curve, by the part of the volume that is solid,
  // b = 1 / alpha.
  struct Line {
    double pressure;    // Pa, p*
    double distension;  // -, alpha*
    double solid_part;  // -, 1 / alpha*
    double slope;       // 1/Pa, d(1/alpha)/dp
    MORAINE_HD double at(double p) const { return solid_part - slope * (pressure - p); }
  };

  // Of pressures [Pa].
  MORAINE_HD double rounding() const { return 1e-14 * stiffness(); }

  MORAINE_HD double elastic_slope(double h) const { return (1.0 / (h * h) - 1.0) / stiffness(); }

  MORAINE_HD double elastic_slope_after(CrushCurve const& curve, double alpha) const {
    double const pores = (alpha - 1.0) / (curve.distension - 1.0);
    return elastic_slope(1.0 - (1.0 - reference_sound_speed / solid_sound_speed) * pores);
  }

  MORAINE_HD Line elastic_line(CrushCurve const& curve, double least) const {
    double const alpha = least < curve.distension ? (least > 1.0 ? least : 1.0) : curve.distension;
    return {curve.pressure_at(alpha), alpha, 1.0 / alpha, elastic_slope_after(curve, alpha)};
  }

  MORAINE_HD double solid_part_of_virgin(double p) const {
    CrushCurve const curve = crush_curve();
    if (p <= elastic_limit) return elastic_line(curve, curve.distension).at(p);
    return 1.0 / curve.distension_at(p);
  }

  // p - b p_solid(rho / b, e) and its derivative by p, with b(p) and its slope. It rises with p.
  MORAINE_HD ValueAndSlope excess(double p, double b, double slope, double rho, double e) const {
    SquaredResponse const grains = solid().respond_squared(rho / b, e);
    return {p - b * grains.pressure, 1.0 + slope * resistance(grains, rho / b)};
  }

  // rho_solid dp_solid/drho_solid - p_solid [Pa], at constant energy.
  MORAINE_HD double resistance(SquaredResponse const& grains, double rho) const {
    return rho * grains.sound_speed_squared -
           grains.pressure * (1.0 + grueneisen_coefficient * solid_density / rho);
  }

  MORAINE_HD double sound_speed_squared_at(double b, double slope, double rho, double e) const {
    SquaredResponse const grains = solid().respond_squared(rho / b, e);
    return grains.sound_speed_squared / (1.0 + slope * resistance(grains, rho / b));
  }

  MORAINE_HD CompactionResponse compact(double rho, double e) const {
    UsUp bounded = solid();
    bounded.least_pressure = least_pressure;
    SquaredResponse const response = bounded.respond_squared(rho, e);
    double const c2 = response.sound_speed_squared;
    return {response.pressure, c2, 1.0, c2};
  }

  // `guess` is the pressure if the line were straight in the density.
  MORAINE_HD CompactionResponse on_line(Line const& line, double guess, double rho,
                                        double e) const {
    auto const at = [&](double p) { return excess(p, line.at(p), line.slope, rho, e); };
    if (guess <= least_pressure && at(least_pressure).value >= 0.0) return at_floor(line, e);
    double const p = increasing_root(at, least_pressure, line.pressure, guess, rounding());
    if (p <= least_pressure) return at_floor(line, e);
    double const c2 = sound_speed_squared_at(line.at(p), line.slope, rho, e);
    return {p, c2, line.distension, c2};
  }

  MORAINE_HD CompactionResponse at_floor(Line const& line, double e) const {
    double const b = line.at(least_pressure);
    double const met = b * solid().density_at_pressure(least_pressure / b, e);
    double const c2 = met > 0.0 ? sound_speed_squared_at(b, line.slope, met, e)
                                : -solid_sound_speed * solid_sound_speed;
    return {least_pressure, c2, line.distension, c2};
  }

  MORAINE_HD CompactionResponse on_curve(CrushCurve const& curve, Line const& from, double rho,
                                         double e) const {
    auto const at = [&](double p) {
      auto const [alpha, slope] = curve.at(p);
      return excess(p, 1.0 / alpha, -slope / (alpha * alpha), rho, e);
    };
    // As if the grains were rigid.
    double const guess = curve.pressure_at(solid_density / rho);
    double const p =
        increasing_root(at, from.pressure, full_compaction_pressure, guess, rounding());
    auto const [alpha, slope] = curve.at(p);
    auto const c2 = [&, alpha = alpha](double by_pressure) {
      return sound_speed_squared_at(1.0 / alpha, by_pressure, rho, e);
    };
    return {p, c2(-slope / (alpha * alpha)), alpha < from.distension ? alpha : from.distension,
            c2(elastic_slope_after(curve, alpha))};
  }
};

inline bool PAlpha::unloads_steeply() const {
  constexpr int stages = 1000;
  CrushCurve const curve = crush_curve();
  for (int k = 0; k < stages; ++k) {
    double const alpha = curve.distension - (curve.distension - 1.0) * k / stages;
    double const crushed = -curve.at(curve.pressure_at(alpha)).slope / (alpha * alpha);
    if (elastic_line(curve, alpha).slope > crushed * (1.0 + 1e-6)) return false;
  }
  return true;
}

}  // namespace moraine
