// moraine slosh: linear theory of the liquid in a rigid tank.
#pragma once

#include <optional>
#include <string>

#include "app/record_options.hpp"

namespace CLI {
class App;
}

namespace moraine {

struct SloshOptions {
  std::string length, depth, width = "1 m", density = "1000 kg/m^3", gravity = "1 g0", freeboard;
  int modes = 5;          // in the table
  int summed_modes = 40;  // odd ones, in the response
  double damping = 0.005;
  std::string free_time;
  RecordOptions records;
  bool json = false, csv = false, force = false;
  std::string history;  // file
  std::string plot;     // file
};

/// Makes the command known to the command line.
void add_slosh_command(CLI::App& app, SloshOptions& options);

/// Runs the command if it is this one: exit code, or nothing for another command.
std::optional<int> run_slosh_command(CLI::App const& app, SloshOptions const& options);

}  // namespace moraine
