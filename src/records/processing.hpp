// What is done to a record before it is used.
#pragma once

#include <optional>

#include "records/baseline.hpp"
#include "records/butterworth.hpp"
#include "records/resample.hpp"

namespace moraine {

/// Steps in the order in which they are done. The baseline comes after all that changes the shape,
/// so that a record brought to rest stays at rest, and the peak last, so that it is met.
struct Processing {
  std::optional<double> until;      // s, in the time of the file
  std::optional<double> high_pass;  // Hz, corner in the time of the file; second order, both ways
  std::optional<double> low_pass;   // Hz, the same
  double time_scale = 1.0;          // factor of all times
  std::optional<double> time_step;  // s, after the time scale
  Interpolation interpolation = Interpolation::band_limited;
  Baseline baseline = Baseline::none;
  std::optional<double> peak;  // m/s^2
};

/// The processed record. Throws std::invalid_argument as the single steps do.
GroundRecord processed(GroundRecord record, Processing const& processing);

}  // namespace moraine
