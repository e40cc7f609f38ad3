// moraine blast: answers about explosions without a simulation.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moraine {

/// What was written behind `moraine blast TOPIC`, by option, as it was written.
struct BlastOptions {
  std::map<std::string, std::string> values;
  std::vector<std::string> sweep;   // first, last, count
  std::vector<std::string> extras;  // what is no option
  bool surface_burst = false;
  bool json = false;
  bool list = false;
  bool force = false;
};

/// Makes the command and one command per topic known to the command line.
void add_blast_command(CLI::App& app, BlastOptions& options);

/// Runs it: exit code, or nothing for another command. Throws InputErrors with all mistakes.
std::optional<int> run_blast_command(CLI::App const& app, BlastOptions options);

}  // namespace moraine
