#include "output/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "output/output_error.hpp"

namespace moraine {
namespace {

/// False if another has it; a file system without locks refuses nobody.
bool lock(int file) {
  int status = 0;
  do status = ::flock(file, LOCK_EX | LOCK_NB);
  while (status != 0 && errno == EINTR);
  return status == 0 || errno != EWOULDBLOCK;
}

}  // namespace

std::optional<RunLock> RunLock::take(std::filesystem::path const& folder) {
  auto const path = folder / "lock";
  int const file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) throw OutputError("cannot open '" + path.string() + "': " + std::strerror(errno));
  RunLock taken(file);
  if (!lock(file)) return std::nullopt;
  return taken;
}

bool RunLock::is_held(std::filesystem::path const& folder) {
  int const file = ::open((folder / "lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  RunLock const probe(file);
  return !lock(file);
}

RunLock::RunLock(RunLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

RunLock::~RunLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace moraine
