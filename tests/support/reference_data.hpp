// Reference values of the folder tests/data, made by make_reference.py there.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace moraine {

/// Rows of numbers of a file in tests/data, a CSV with one header line. A missing file fails the
/// test.
inline std::vector<std::vector<double>> reference_data(std::string const& name) {
  std::ifstream file(std::string(MORAINE_SOURCE_DIR) + "/tests/data/" + name);
  EXPECT_TRUE(file) << name;
  std::vector<std::vector<double>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

}  // namespace moraine
