// Reference values: of the folder tests/data, made by make_reference.py there, and of a folder
// shared/data beside the project, which not every copy of the project has.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/places.hpp"
#include "support/shared_data.hpp"

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
  auto rows = csv_numbers(source_folder() + "/tests/data/" + name);
  EXPECT_FALSE(rows.empty()) << name;
  return rows;
}

}  // namespace moraine

/// Leaves the test as skipped where a file of the shared data is missing.
#define MORAINE_NEED_SHARED_DATA(name)      \
  if (::moraine::shared_data(name).empty()) \
  GTEST_SKIP() << (name) << ": " << ::moraine::no_shared_data
