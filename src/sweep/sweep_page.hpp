// The page that compares the members of a sweep.
#pragma once

#include <filesystem>
#include <string>

namespace moraine {

/// Whether a folder holds the results of a sweep.
bool holds_a_sweep(std::filesystem::path const& folder);

/// Writes a report (report/report.hpp) of all members of the sweep in `folder` that have a run: the
/// table of the sweep, plots of outputs over parameters, and the curves of the members over each
/// other. `title`: empty: that of the sweep. Throws std::runtime_error if sweep.json is missing or
/// malformed, OutputError if the page cannot be written.
void write_sweep_page(std::filesystem::path const& folder, std::filesystem::path const& page,
                      std::string const& title = {});

}  // namespace moraine
