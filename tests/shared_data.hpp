// Reference data that are not part of the sources: the folder `shared` beside them.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace moraine {

/// Path of a file of the shared folder: below $MORAINE_SHARED, else ../shared beside the sources.
inline std::filesystem::path shared_file(std::string const& name) {
  if (char const* folder = std::getenv("MORAINE_SHARED"))
    return std::filesystem::path(folder) / name;
  return std::filesystem::path(MORAINE_SOURCE_DIR) / ".." / "shared" / name;
}

/// Rows of numbers of a CSV file with one header line; empty if the file is not there.
inline std::vector<std::vector<double>> read_numbers(std::filesystem::path const& path) {
  std::ifstream file(path);
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
