// This program once more, as a process of its own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moraine {

/// A started `moraine WORDS...` whose output is appended to a file. It is in a process group of its
/// own, so that Ctrl-C does not reach it, and is asked to stop (SIGTERM) when the process that
/// started it ends, however that ends.
class ChildProcess {
 public:
  /// Throws OutputError if no process can be started or the file cannot be opened.
  ChildProcess(std::vector<std::string> words, std::filesystem::path const& log);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  /// Asks a process that is still there to stop, and waits for it.
  ~ChildProcess();

  /// The exit code, or 128 and the number of the signal that ended it; nothing while it runs. Call
  /// no more once it has ended.
  std::optional<int> ended();

  void ask_to_stop() const;

 private:
  pid_t process_ = -1;
};

}  // namespace moraine
