#include "support/program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "support/places.hpp"

namespace moraine {
namespace {

std::string text_of(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// In the child: everything is set, become the program.
[[noreturn]] void become(char const* folder, char** arguments, rlim_t largest_file) {
  rlimit const limit{largest_file, RLIM_INFINITY};
  // Before any file is made: without its folder they would land wherever the tests run.
  if (chdir(folder) != 0) _exit(127);
  bool const ready = setenv("OMP_NUM_THREADS", "2", 1) == 0 && setrlimit(RLIMIT_FSIZE, &limit) == 0;
  int const flags = O_WRONLY | O_CREAT | O_TRUNC;
  int const out = open("out", flags, 0600);
  int const err = open("err", flags, 0600);
  if (ready && out >= 0 && err >= 0 && dup2(out, STDOUT_FILENO) >= 0 &&
      dup2(err, STDERR_FILENO) >= 0)
    execv(program_file(), arguments);
  _exit(127);
}

}  // namespace

Program::Program(std::filesystem::path folder, std::vector<std::string> const& arguments,
                 rlim_t largest_file)
    : folder_(std::move(folder)) {
  std::vector<std::string> words{"moraine"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  process_ = fork();
  if (process_ < 0) throw std::runtime_error("cannot start a process");
  if (process_ == 0) become(folder_.c_str(), pointers.data(), largest_file);
}

void Program::send(int signal) const { kill(process_, signal); }

CommandResult Program::wait() {
  int status = 0;
  if (waitpid(process_, &status, 0) != process_) throw std::runtime_error("lost a process");
  int const code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, text_of(folder_ / "out"), text_of(folder_ / "err")};
}

CommandResult moraine_command(std::filesystem::path const& folder,
                              std::vector<std::string> const& arguments) {
  return Program(folder, arguments).wait();
}

}  // namespace moraine
