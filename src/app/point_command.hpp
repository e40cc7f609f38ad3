// moraine point: a laboratory test on one point of a material.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace moraine {

struct PointOptions {
  std::string material;   // of those shipped, or of the case
  std::string case_file;  // empty: shipped materials
  std::string path = "uniaxial";
  std::string confinement = "0 Pa";
  std::string strain = "0.1";
  int steps = 1000;
  std::string csv;   // file, or - for the output
  std::string plot;  // file; empty: none
};

void add_point_command(CLI::App& app, PointOptions& options);
std::optional<int> run_point_command(CLI::App const& app, PointOptions const& options);

}  // namespace moraine
