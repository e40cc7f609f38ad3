// moraine sweep: a case with other values, many times.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace moraine {

struct SweepOptions {
  std::string file;
  std::string output;
  int at_once = 0;  // 0: as the file says
  int threads = 0;  // 0: all
  bool list = false;
  bool force = false;
};

/// Makes the command known to the command line.
void add_sweep_command(CLI::App& app, SweepOptions& options);

/// Runs the command if it is this one: exit code, or nothing for another command.
std::optional<int> run_sweep_command(CLI::App const& app, SweepOptions const& options);

}  // namespace moraine
