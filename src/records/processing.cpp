#include "records/processing.hpp"

#include <utility>

namespace moraine {

GroundRecord processed(GroundRecord record, Processing const& processing) {
  if (processing.until) record = cut_after(std::move(record), *processing.until);
  if (processing.high_pass)
    record =
        filtered(std::move(record), {Passband::high, *processing.high_pass, 2, Passes::both_ways});
  if (processing.low_pass)
    record =
        filtered(std::move(record), {Passband::low, *processing.low_pass, 2, Passes::both_ways});
  record = time_scaled(std::move(record), processing.time_scale);
  if (processing.time_step)
    record = resampled(record, *processing.time_step, processing.interpolation);
  record = baseline_corrected(std::move(record), processing.baseline);
  if (processing.peak) record = scaled_to_peak(std::move(record), *processing.peak);
  return record;
}

}  // namespace moraine
