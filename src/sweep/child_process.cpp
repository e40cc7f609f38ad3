#include "sweep/child_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "output/output_error.hpp"

namespace moraine {
namespace {

/// In the child, where only system calls are safe.
[[noreturn]] void become(char* const* words, int log, pid_t parent) {
  int const nothing = ::open("/dev/null", O_RDONLY);
  bool const ready = ::prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && ::getppid() == parent &&
                     ::setpgid(0, 0) == 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
                     ::dup2(log, STDOUT_FILENO) >= 0 && ::dup2(log, STDERR_FILENO) >= 0;
  if (ready) ::execv("/proc/self/exe", words);
  ::_exit(127);
}

int exit_code(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> words, std::filesystem::path const& log) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int const file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw OutputError("cannot open '" + log.string() + "': " + std::strerror(errno));
  pid_t const parent = ::getpid();
  process_ = ::fork();
  if (process_ == 0) become(pointers.data(), file, parent);
  int const error = errno;
  ::close(file);
  if (process_ < 0) throw OutputError(std::string("cannot start a run: ") + std::strerror(error));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)) {}

ChildProcess::~ChildProcess() {
  if (process_ < 0) return;
  ask_to_stop();
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
}

std::optional<int> ChildProcess::ended() {
  int status = 0;
  pid_t const found = ::waitpid(process_, &status, WNOHANG);
  if (found == 0 || (found < 0 && errno == EINTR)) return std::nullopt;
  process_ = -1;
  return found < 0 ? 127 : exit_code(status);
}

void ChildProcess::ask_to_stop() const {
  if (process_ > 0) ::kill(process_, SIGTERM);
}

}  // namespace moraine
