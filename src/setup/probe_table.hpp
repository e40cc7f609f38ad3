// The table of parameters: keys of the kinds of gauges beyond points and fronts.
#pragma once

#include <vector>

#include "setup/binding.hpp"
#include "setup/case.hpp"

namespace moraine {

/// Appends the keys of all gauge kinds but point and front.
void add_probe_entries(std::vector<Entry<GaugeSpec>>& table);

}  // namespace moraine
