#include "setup/starters.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "base/input_error.hpp"

namespace moraine {
namespace {

[[noreturn]] void refuse(std::string const& what, std::string rule, std::string hint) {
  throw InputErrors({{.file = "moraine new",
                      .line = 0,
                      .column = 0,
                      .key = "",
                      .value = fmt::format("\"{}\"", what),
                      .rule = std::move(rule),
                      .hint = std::move(hint)}});
}

std::string_view starter(std::string_view kind) {
  std::vector<std::string_view> names;
  for (auto const& [name, text] : starter_texts()) {
    if (name == kind) return text;
    names.push_back(name);
  }
  refuse(std::string(kind), "is no kind of starter case", name_hint(kind, names));
}

}  // namespace

void write_starter(std::string_view kind, std::filesystem::path const& file) {
  std::string_view text = starter(kind);
  // O_EXCL: a file that appears in between is not overwritten either.
  int const target = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (target < 0 && errno == EEXIST)
    refuse(file.string(), "exists and is not overwritten", "name another file");
  if (target < 0) refuse(file.string(), fmt::format("cannot be written: {}", strerror(errno)), "");
  while (!text.empty()) {
    ssize_t const written = write(target, text.data(), text.size());
    if (written < 0) {
      int const error = errno;
      close(target);
      unlink(file.c_str());
      refuse(file.string(), fmt::format("cannot be written: {}", strerror(error)), "");
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  close(target);
}

}  // namespace moraine
