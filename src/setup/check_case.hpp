// What a case must fulfil beyond its single values, and the default of the domain.
#pragma once

#include <string>
#include <vector>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Full keys of the items of a case, in the order of its vectors: "region.charge", "wall[2]".
struct ItemKeys {
  std::vector<std::string> regions;
  std::vector<std::string> walls;
  std::vector<std::string> gauges;
  std::vector<std::string> stages;
  std::vector<std::string> references;
};

/// Finds the domain if the file gives none, completes shapes (check_region.hpp), and reports
/// contradictions: names used twice or unknown, empty boxes, a state given twice over,
/// hydrostatic_level without gravity, parts outside the domain, a periodic domain that is no whole
/// number of spacings. Values with a reported mistake are left out.
void finish_case(Case& c, ItemKeys const& keys, Source& source);

}  // namespace moraine
