// At most one run writes into a folder.
#pragma once

#include <filesystem>
#include <optional>

namespace moraine {

/// The right to write into the folder of a run, held by one process at a time while the object
/// lives: a lock (flock) on the file `lock` in the folder. The system gives it back when the
/// process ends, however it ends; the file stays and means nothing by itself.
///
/// Between machines that share a folder the lock holds as far as their file system carries flock
/// over: NFS does since Linux 2.6.12. Where it has no locks at all a run goes on without.
class RunLock {
 public:
  /// The lock of an existing folder; nothing if another process, or another object of this one, has
  /// it. Throws OutputError if the file cannot be made.
  static std::optional<RunLock> take(std::filesystem::path const& folder);

  /// Whether another process holds the lock. Makes no file; a folder without one is free.
  static bool is_held(std::filesystem::path const& folder);

  RunLock(RunLock&& other) noexcept;
  RunLock& operator=(RunLock&&) = delete;
  ~RunLock();

 private:
  explicit RunLock(int file) : file_(file) {}

  int file_;
};

}  // namespace moraine
