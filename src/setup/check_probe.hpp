// What gauges must fulfil beyond their single values.
#pragma once

#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports names of walls and materials that the case does not have, empty boxes, lines without
/// length, sides that nothing can leave through, and what check_measures.hpp finds. `key`: full key
/// of the gauge.
void check_probe(Case const& c, GaugeSpec const& gauge, std::string const& key, Source& source);

/// Reports ends of lines and other places outside of the domain, which must be known.
void check_probe_places(Case const& c, GaugeSpec const& gauge, std::string const& key,
                        Source& source);

}  // namespace moraine
