// What a gauge of a run says of the measures that relations give.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "blast/estimate.hpp"

namespace moraine::blast {

/// Readings of one gauge, in SI; those that do not exist are left out. Without a name: none.
struct GaugeReadings {
  struct Reading {
    Measure measure;
    double value;
  };
  std::string gauge;
  std::vector<Reading> readings;

  std::optional<double> of(Measure measure) const;
};

/// Reads a gauge out of the `gauges.json` of a run: from its first column of pressures the largest
/// rise above the first reading (as peak overpressure and peak pressure), the impulse of that rise
/// over the whole run, and the arrival since the start of the run. Throws InputErrors for a file
/// that cannot be read, a gauge that is not in it, and one without a pressure that was seen.
GaugeReadings read_gauge(std::filesystem::path const& file, std::string const& gauge);

/// The first recommended estimate of a measure within its range, or null: what a reading is
/// compared with.
Estimate const* yardstick(Answer const& answer, Measure measure);

}  // namespace moraine::blast
