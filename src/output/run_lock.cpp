#include "output/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include "output/output_error.hpp"

namespace moraine {
namespace {

/// How long a look of somebody else at the lock may last.
constexpr std::chrono::milliseconds longest_look(500);

/// False if another has it; a file system without locks refuses nobody.
bool lock(int file, int kind) {
  int status = 0;
  do status = ::flock(file, kind | LOCK_NB);
  while (status != 0 && errno == EINTR);
  return status == 0 || errno != EWOULDBLOCK;
}

}  // namespace

std::optional<RunLock> RunLock::take(std::filesystem::path const& folder) {
  auto const path = folder / "lock";
  int const file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw OutputError("cannot open '" + path.string() + "': " + std::strerror(errno));
  RunLock taken(file);
  // Whoever looks whether it is held holds it himself for a moment.
  auto const start = std::chrono::steady_clock::now();
  while (!lock(file, LOCK_EX)) {
    if (std::chrono::steady_clock::now() - start > longest_look) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return taken;
}

bool RunLock::is_held(std::filesystem::path const& folder) {
  int const file = ::open((folder / "lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  RunLock const probe(file);
  return !lock(file, LOCK_SH);  // those who look do not see each other
}

RunLock::RunLock(RunLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

RunLock::~RunLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace moraine
