// Commands about case files: check, explain, materials, new, schema.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace moraine {

struct CaseCommandOptions {
  std::string case_file;   // check, explain --step
  std::string name;        // key, material or kind of starter
  std::string file;        // new
  bool json = false;       // check
  bool reference = false;  // explain
  int threads = 0;         // check; 0: all
};

/// Makes these commands known to the command line.
void add_case_commands(CLI::App& app, CaseCommandOptions& options);

/// Runs the command if it is one of these: exit code, or nothing for another command.
std::optional<int> run_case_command(CLI::App const& app, CaseCommandOptions const& options);

}  // namespace moraine
