// Measurements of others, which stand beside the project and are no part of it.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/places.hpp"
#include "verify/reference_data.hpp"

namespace moraine {

/// A file of reference_data.hpp, beside the sources. Empty where it is not there:
///   auto const file = shared_data("seismic/NAME.csv");
///   if (file.empty()) GTEST_SKIP() << no_shared_data;
inline std::filesystem::path shared_data(std::string const& name) {
  return reference_file(name, source_folder());
}

inline constexpr char const* no_shared_data = no_reference_data;

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
