#include "bench/process.hpp"

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace moraine {
namespace {

constexpr char good = '+', bad = '-';  // first letter of what a child says

void write_all(int file, std::string const& text) {
  for (std::size_t done = 0; done < text.size();) {
    ssize_t const written = ::write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) return;  // the parent is gone
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

std::string read_all(int file) {
  std::string text;
  char buffer[4096];
  for (;;) {
    ssize_t const got = ::read(file, buffer, sizeof(buffer));
    if (got > 0) text.append(buffer, static_cast<std::size_t>(got));
    if (got == 0 || (got < 0 && errno != EINTR)) return text;
  }
}

[[noreturn]] void be_child(int to_parent, std::function<std::string()> const& work) {
  std::string said;
  try {
    said = good + work();
  } catch (std::exception const& error) {
    said = std::string(1, bad) + error.what();
  }
  write_all(to_parent, said);
  ::_exit(0);  // the parent owns all open files and whatever waits in their buffers
}

}  // namespace

ResidentMemory resident_memory() {
  std::ifstream status("/proc/self/status");
  ResidentMemory memory;
  std::string line;
  while (std::getline(status, line)) {
    unsigned long kilobytes = 0;
    if (std::sscanf(line.c_str(), "VmRSS: %lu kB", &kilobytes) == 1) memory.now = kilobytes * 1024;
    if (std::sscanf(line.c_str(), "VmHWM: %lu kB", &kilobytes) == 1) memory.peak = kilobytes * 1024;
  }
  if (memory.peak == 0) throw std::runtime_error("/proc/self/status does not tell memory (VmHWM)");
  return memory;
}

double processor_seconds() {
  timespec used{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line)) {
    if (line.rfind("model name", 0) != 0) continue;
    auto const colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string in_child(std::function<std::string()> const& work) {
  int ends[2];
  if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::fflush(nullptr);
  pid_t const child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    ::close(ends[0]);
    be_child(ends[1], work);
  }
  ::close(ends[1]);
  std::string const said = read_all(ends[0]);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (said.empty()) throw std::runtime_error("the process of a workload ended without a result");
  if (said[0] == bad) throw std::runtime_error(said.substr(1));
  return said.substr(1);
}

}  // namespace moraine
