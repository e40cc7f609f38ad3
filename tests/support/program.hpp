// Starts the built program as a user does, and looks at what it leaves behind.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace moraine {

/// How a command ended: exit code (128 + number for a signal that killed it) and what it said.
struct CommandResult {
  int code = -1;
  std::string out;
  std::string err;
};

/// A started `moraine ARGUMENTS...` with `folder` as its working directory; its output goes to the
/// files `out` and `err` there. No file that it writes can get larger than `largest_file` bytes.
class Program {
 public:
  Program(std::filesystem::path folder, std::vector<std::string> const& arguments,
          rlim_t largest_file = RLIM_INFINITY);

  /// Sends a signal.
  void send(int signal) const;

  /// Waits for the end.
  CommandResult wait();

 private:
  std::filesystem::path folder_;
  pid_t process_ = -1;
};

/// Runs `moraine ARGUMENTS...` to its end.
CommandResult moraine_command(std::filesystem::path const& folder,
                              std::vector<std::string> const& arguments);

}  // namespace moraine
