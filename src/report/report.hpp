// Reports of runs: one HTML file that anybody can open.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/blocks.hpp"

namespace moraine::report {

/// Where a report ends up, and how large it may get.
struct ReportOptions {
  std::filesystem::path file;
  std::string title{};   // empty: that of the run
  Json sweep = nullptr;  // type Sweep of report/FORMAT.md
  std::size_t most_bytes_without_particles = 1'000'000;
  std::size_t most_bytes = 15'000'000;
};

/// Writes the report of one or several runs, whose curves are then drawn over each other. Reads
/// nothing but their folders. What is too large is thinned or left out (draft.hpp, particles.hpp),
/// and the report says so. Throws InputErrors for folders that hold no run, OutputError if the file
/// cannot be written.
void write_report(std::vector<std::filesystem::path> const& folders, ReportOptions const& options);

/// The same as data for a live page of one run: smaller, with the blocks inside.
Json live_data(std::filesystem::path const& folder);

/// A page that asks for its data every `interval` seconds (report/FORMAT.md).
std::string live_page(std::string const& title, double interval);

}  // namespace moraine::report
