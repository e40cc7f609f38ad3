// What a run has left in its folder, read for a report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "output/pvd_collection.hpp"
#include "output/table_csv.hpp"
#include "setup/case.hpp"

namespace moraine::report {

/// The files of a run. Pieces that are not there, or that cannot be understood, are empty; `notes`
/// says what is wrong with them.
struct RunFiles {
  std::filesystem::path folder;
  std::string name;         // of the folder; unique in a report
  std::string prefix;       // of its blocks, "run-0"
  nlohmann::json manifest;  // objects, empty where there is no file
  nlohmann::json status;
  nlohmann::json gauge_summary;
  std::optional<Case> used_case;
  Table gauges, sums;
  std::vector<PvdEntry> frames;       // files relative to the folder
  std::vector<PvdEntry> wall_frames;  // where walls move
  bool going_on = false;              // another process is writing here now
  std::vector<std::string> notes;
};

/// Reads a folder. Throws InputErrors if it is not the folder of a run.
RunFiles read_run_files(std::filesystem::path const& folder);

/// "running", "ended", "stopped" or "broken" (report/FORMAT.md): what the files say, and whether
/// somebody is still there to write them.
std::string_view state_of(RunFiles const& run);

/// Why it ended; empty while it runs, and where nothing was written about it.
std::string end_reason(RunFiles const& run);

/// A number of a JSON object, or nothing.
std::optional<double> number_at(nlohmann::json const& object, char const* key);
/// A text of a JSON object; empty where there is none.
std::string text_at(nlohmann::json const& object, char const* key);

}  // namespace moraine::report
