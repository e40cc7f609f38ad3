// moraine exact: exact solutions to compare with.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moraine {

struct ExactOptions {
  std::string name;  // empty: list all
  bool list = false;
  std::string time;  // with unit or SI; empty: that of the solution
  int points = 400;
  std::vector<std::string> parameters;  // key=value
  std::string csv;                      // file, "-" for the output, or empty
  bool json = false;
  std::string plot;  // picture, or empty
};

/// Makes the command known to the command line.
void add_exact(CLI::App& app, ExactOptions& options);

/// Throws InputErrors for anything that cannot be solved; then nothing is written.
int run_exact(ExactOptions const& options);

}  // namespace moraine
