// What a case asked for, as a report shows it.
#pragma once

#include <string>

#include "report/blocks.hpp"
#include "report/run_files.hpp"

namespace moraine::report {

/// The settings of a run as in the format; empty where its case cannot be read.
Json settings_json(RunFiles const& run);

/// The word of the case file for the kind of a gauge.
std::string kind_name(GaugeSpec const& gauge);

}  // namespace moraine::report
