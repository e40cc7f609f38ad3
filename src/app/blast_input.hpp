// From options as written to a situation in SI, with all mistakes at once.
#pragma once

#include <string>
#include <vector>

#include "app/blast_command.hpp"
#include "app/blast_topics.hpp"
#include "output/blast/gauge_readings.hpp"
#include "output/blast/output_units.hpp"

namespace moraine {

/// Values of one input, in the unit in which they were written.
struct Sweep {
  std::vector<double> points;
  std::string unit;
  double factor = 1.0;  // SI value of one unit, times what the explosive does to a mass
  double& (*target)(blast::Situation&) = nullptr;
};

/// What a command was asked.
struct BlastInput {
  blast::Situation situation;
  blast::OutputUnits units;
  Sweep sweep;                     // without points: one answer
  blast::GaugeReadings gauge;      // of a run, to set beside the answer
  std::vector<std::string> notes;  // what was derived, and what to mind about it
};

/// Throws InputErrors with everything that is wrong.
BlastInput read_blast_input(TopicCommand const& command, BlastOptions const& options);

}  // namespace moraine
