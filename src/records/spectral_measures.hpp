// Measures of a record that are read off its response spectra, at 5 % of critical damping.
#pragma once

#include "records/ground_record.hpp"

namespace moraine {

/// Integrals of spectra over the period, by the trapezoidal rule over steps of 0.01 s.
struct SpectrumIntensities {
  double velocity = 0.0;         // m, int Sv dT from 0.1 to 2.5 s
  double pseudo_velocity = 0.0;  // m, int PSV dT, same periods; Housner, 2nd WCEE (1952)
  double acceleration = 0.0;     // m/s, int PSA dT from 0.1 to 0.5 s
};

/// All three. Von Thun et al., ASCE Geotech. Spec. Publ. 20 (1988) 115.
SpectrumIntensities spectrum_intensities(GroundRecord const& record);

/// The periods [s] between which the predominant one is looked for.
double shortest_predominant_period(double time_step);  // five time steps, at least 0.02 s
inline constexpr double longest_predominant_period = 4.0;

/// The period with the largest pseudo acceleration at 5 % damping [s] in that range, to 0.01 %: the
/// best of periods at equal ratios of 1 %, refined between its neighbours.
double predominant_period(GroundRecord const& record);

/// A quick look for it between a quarter and four times `about` [s]: right to 3 % where it lies
/// there and no other peak is within 2 %.
double rough_predominant_period(GroundRecord const& record, double about);

/// Peak of the acceleration below 9 Hz [m/s^2]: second-order Butterworth, both ways. It may exceed
/// the peak of the record. Benjamin & Associates, EPRI NP-5930 (1988).
double effective_design_acceleration(GroundRecord const& record);

}  // namespace moraine
