// The page of a run that is going on, for browsers on this machine.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

namespace moraine::watch {

/// Serves `/` and `/data.json` (report/FORMAT.md) of one run, on the loopback address alone and for
/// reading alone: other methods, other paths and requests in the name of another host are refused.
class LiveServer {
 public:
  explicit LiveServer(std::filesystem::path folder);
  ~LiveServer();

  /// Takes a port (0: any that is free) and returns it. Throws std::runtime_error where it is not
  /// to be had.
  int bind(int port);

  /// Serves until `stop` is called from another thread.
  void serve();
  void stop();

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace moraine::watch
