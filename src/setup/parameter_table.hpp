// The one table of parameters. Everything that the case file can say is listed here, once.
#pragma once

#include <span>
#include <vector>

#include "setup/binding.hpp"
#include "setup/case.hpp"

namespace moraine {

/// Entries by section, in the order of reading: a choice stands before the keys that depend on it.
std::span<Entry<Case> const> case_entries();
std::span<Entry<MaterialSpec> const> material_entries();
std::span<Entry<RegionSpec> const> region_entries();
std::span<Entry<WallSpec> const> wall_entries();
std::span<Entry<GaugeSpec> const> gauge_entries();
std::span<Entry<StageSpec> const> stage_entries();
std::span<Entry<ReferenceSpec> const> reference_entries();

/// The whole table as data, section after section, without the bindings.
std::vector<Parameter const*> all_parameters();

}  // namespace moraine
