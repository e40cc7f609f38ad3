// Measurements of others, which stand beside the project and are no part of it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace moraine {

/// A file of the reference data: in the folder that MORAINE_REFERENCE_DATA names, else in
/// ../shared/data beside the sources. Empty where it is not there:
///   auto const file = shared_data("seismic/NAME.csv");
///   if (file.empty()) GTEST_SKIP() << no_shared_data;
inline std::filesystem::path shared_data(std::string const& name) {
  char const* const told = std::getenv("MORAINE_REFERENCE_DATA");
  std::filesystem::path const folder =
      told != nullptr ? std::filesystem::path(told)
                      : std::filesystem::path(MORAINE_SOURCE_DIR).parent_path() / "shared" / "data";
  std::filesystem::path const file = folder / name;
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

inline constexpr char const* no_shared_data =
    "the reference data are not here; MORAINE_REFERENCE_DATA may name their folder";

/// Cells of a CSV file by rows, the header line first.
inline std::vector<std::vector<std::string>> shared_rows(std::filesystem::path const& file) {
  std::ifstream stream(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

}  // namespace moraine
