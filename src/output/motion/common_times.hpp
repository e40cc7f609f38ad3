// Histories with different steps of time on one axis.
#pragma once

#include <vector>

#include "records/ground_record.hpp"

namespace moraine {

/// Times that hold all records: from the first start to the last end at the finest step, at most
/// 200 000 of them [s].
std::vector<double> common_times(std::vector<GroundRecord> const& records);

/// Accelerations [m/s^2] in units of standard gravity.
std::vector<double> in_g(std::vector<double> accelerations);

/// A history of a record at other times, straight between its values; not a number outside.
std::vector<double> at_times(GroundRecord const& record, std::vector<double> const& history,
                             std::vector<double> const& times);

}  // namespace moraine
