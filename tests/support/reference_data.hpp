// Reference values: of the folder tests/data, made by make_reference.py there, and of a folder
// shared/data beside the project, which not every copy of the project has.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace moraine {

/// Rows of a CSV file with one header line, as text. Empty if there is no such file.
inline std::vector<std::vector<std::string>> csv_cells(std::filesystem::path const& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

/// The same, as numbers.
inline std::vector<std::vector<double>> csv_numbers(std::filesystem::path const& path) {
  std::vector<std::vector<double>> rows;
  for (auto const& cells : csv_cells(path)) {
    std::vector<double>& row = rows.emplace_back();
    for (std::string const& cell : cells) row.push_back(std::stod(cell));
  }
  return rows;
}

/// Rows of numbers of a file in tests/data. A missing file fails the test.
inline std::vector<std::vector<double>> reference_data(std::string const& name) {
  auto rows = csv_numbers(std::string(MORAINE_SOURCE_DIR) + "/tests/data/" + name);
  EXPECT_FALSE(rows.empty()) << name;
  return rows;
}

/// Place of a file of the shared data, by its path there ("blast/sod_exact_t0.2.csv"): below the
/// folder that the environment variable MORAINE_SHARED_DATA names, else below ../shared/data.
inline std::filesystem::path shared_data(std::string const& name) {
  char const* const folder = std::getenv("MORAINE_SHARED_DATA");
  std::filesystem::path const root =
      folder != nullptr ? folder : std::string(MORAINE_SOURCE_DIR) + "/../shared/data";
  return root / name;
}

}  // namespace moraine

/// Leaves the test as skipped where a file of the shared data is missing.
#define MORAINE_NEED_SHARED_DATA(name)                        \
  if (!std::filesystem::exists(::moraine::shared_data(name))) \
  GTEST_SKIP() << ::moraine::shared_data(name).string() << " is not there"
