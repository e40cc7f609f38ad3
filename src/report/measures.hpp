// What the readings of gauges come to over the whole run: peaks, impulses, arrivals, decays.
#pragma once

#include <nlohmann/json.hpp>

#include "report/blocks.hpp"

namespace moraine::report {

/// The columns of gauges.json as a list of the type Measure. Anything may stand in that file: what
/// is no number there is null here, and what is no gauge is left out.
Json measures_of(nlohmann::json const& gauge_summary);

/// The decays with distance that gauges.json holds, as a list of the type Decay.
Json decays_of(nlohmann::json const& gauge_summary);

}  // namespace moraine::report
