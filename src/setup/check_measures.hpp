// What gauges that measure shapes, formulas and planes must fulfil beyond their single values.
#pragma once

#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports materials that the case does not have, empty boxes, heights without a direction,
/// formulas that are none, and grids that are no plane. `key`: full key of the gauge.
void check_measure(Case const& c, GaugeSpec const& gauge, std::string const& key, Source& source);

/// Reports places outside of the domain, which must be known.
void check_measure_places(Case const& c, GaugeSpec const& gauge, std::string const& key,
                          Source& source);

}  // namespace moraine
