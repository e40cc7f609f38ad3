// Intensity measures: what engineers compare ground motions by.
#pragma once

#include "records/ground_record.hpp"

namespace moraine {

/// A stretch of time [s].
struct TimeSpan {
  double from = 0.0;
  double to = 0.0;
  double length() const { return to - from; }
};

/// Measures of one record. Integrals of time run over the whole record by the trapezoidal rule; g
/// is standard gravity. Spectra have 5 % of critical damping.
struct MotionMeasures {
  Peak acceleration;                // PGA, m/s^2
  Peak velocity;                    // PGV, m/s, from rest
  Peak displacement;                // PGD, m, from rest
  double duration;                  // s, first to last value
  double rms_acceleration;          // m/s^2, sqrt(int a^2 dt / duration)
  double arias_intensity;           // m/s, pi/(2g) int a^2 dt
  double characteristic_intensity;  // (a_rms/g)^1.5 sqrt(duration/s)
  double cumulative_velocity;       // CAV, m/s, int |a| dt
  double specific_energy_density;   // m^2/s, int v^2 dt
  double velocity_intensity;        // VSI, m, int Sv dT from 0.1 to 2.5 s, true relative velocity
  double housner_intensity;         // m, the same with the pseudo velocity
  double acceleration_intensity;    // ASI, m/s, int PSA dT from 0.1 to 0.5 s
  double design_acceleration;       // EDA, m/s^2, peak below 9 Hz
  double predominant_period;        // s, of the largest PSA
  double sustained_acceleration;    // m/s^2, third largest half-cycle
  double sustained_velocity;        // m/s, third largest half-cycle
  double a95;                       // m/s^2, below it lie 95 % of int a^2 dt
  TimeSpan significant;             // D5-95: 5 to 95 % of int a^2 dt
  TimeSpan bracketed;               // first and last time above 0.05 g; empty at 0 if never
};

/// All measures. Throws std::invalid_argument for a bad record, one that is zero throughout, and a
/// time step above 0.02 s, which is too coarse for spectra from 0.1 s (shortest_period).
MotionMeasures measure(GroundRecord const& record);

/// The coarsest time step for which `measure` works [s].
inline constexpr double coarsest_measured_step = 0.02;

/// pi/(2g) int a^2 dt [m/s]. Arias, in Hansen (ed.), Seismic Design for Nuclear Power Plants (1970)
/// 438.
double arias_intensity(GroundRecord const& record);

/// a_rms^1.5 sqrt(T), with a_rms in g and T in s. Park, Ang & Wen, J. Struct. Eng. 111 (1985) 740.
double characteristic_intensity(double rms_in_g, double duration);

/// The duration of a record with this Arias intensity [m/s] and a_rms [g]: 2 I / (pi g a_rms^2)
/// [s].
double duration_of(double arias, double rms_in_g);

/// int |a| dt [m/s].
double cumulative_absolute_velocity(GroundRecord const& record);

/// The magnitude of the third largest half-cycle of a history, between zeros; that of the smallest
/// where there are fewer. Nuttli, US Army WES Misc. Paper S-73-1 (1979).
double sustained_maximum(std::vector<double> const& values);

/// The acceleration below which 95 % of int a^2 dt lie [m/s^2]. Sarma & Yang, Earthq. Eng. Struct.
/// Dyn. 15 (1987) 119.
double a95(GroundRecord const& record);

/// When 5 and 95 % of int a^2 dt are reached, straight between values. Trifunac & Brady, Bull.
/// Seism. Soc. Am. 65 (1975) 581.
TimeSpan significant_duration(GroundRecord const& record);

/// First and last time at which the magnitude is above `threshold` [m/s^2], on the straight lines.
/// Bolt, 5th World Conf. Earthq. Eng. (1973).
TimeSpan bracketed_duration(GroundRecord const& record, double threshold);

}  // namespace moraine
