// moraine watch: looks on while a run goes on.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace moraine {

struct WatchOptions {
  std::string folder;
  bool once = false;
  bool web = false;
  int port = 0;  // 0: any that is free
};

void add_watch_command(CLI::App& app, WatchOptions& options);

/// The exit code, or nothing where the command line asks for another command.
std::optional<int> run_watch_command(CLI::App const& app, WatchOptions const& options);

}  // namespace moraine
