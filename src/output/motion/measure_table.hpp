// Measures of ground motions, several side by side.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "records/measures.hpp"

namespace moraine {

/// A record with its measures, and the frequency with the largest power [Hz].
struct MeasuredMotion {
  GroundRecord record;
  MotionMeasures measures;
  double dominant_frequency = 0.0;
};

/// Measures a record; throws as `measure` does.
MeasuredMotion measured_motion(GroundRecord record);

/// One line per measure, one column per record, in the units that engineers use (g is standard
/// gravity), four digits.
std::string measures_as_text(std::vector<MeasuredMotion> const& motions);

/// The same as CSV: measure, unit, one column per record, all digits.
std::string measures_as_csv(std::vector<MeasuredMotion> const& motions);

/// A list of objects in SI units, which stand in the names: "peak_acceleration_m_s2".
nlohmann::json measures_as_json(std::vector<MeasuredMotion> const& motions);

}  // namespace moraine
