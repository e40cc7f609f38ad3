// Measurements as text for people and as JSON for programs.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "bench/measure.hpp"
#include "bench/roof.hpp"

namespace moraine {

/// One object with the keys that docs/performance.md lists. `steps_per_rebuild` is null where the
/// lists were not rebuilt in the timed steps.
nlohmann::ordered_json to_json(Measurement const& measured);

/// The inverse, as far as the keys go: what a child process sends home.
Measurement measurement_from_json(nlohmann::ordered_json const& json);

/// Program, compiler, processor and threads: what a figure means nothing without.
nlohmann::ordered_json machine_to_json(int threads);

/// One object per line.
nlohmann::ordered_json to_json(std::span<RoofLine const> lines);

/// One line of figures per workload.
std::string figures_table(std::span<Measurement const> measured);

/// Where the time of a workload goes: seconds and shares of its timed steps, longest first, and
/// time per step.
std::string actions_table(Measurement const& measured);

}  // namespace moraine
