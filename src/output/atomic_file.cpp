#include "output/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <regex>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "output/output_error.hpp"

namespace moraine {
namespace {

[[noreturn]] void fail(char const* what, std::filesystem::path const& path) {
  throw OutputError(std::string(what) + " '" + path.string() + "': " + std::strerror(errno));
}

void rename_to(std::filesystem::path const& from, std::filesystem::path const& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error)
    throw OutputError("cannot rename '" + from.string() + "' to '" + to.string() +
                      "': " + error.message());
}

/// A temporary name with the number of a process that is gone.
bool is_left_over(std::string const& name) {
  static std::regex const ours(".+\\.([0-9]{1,9})\\.tmp");
  std::smatch found;
  if (!std::regex_match(name, found, ours)) return false;
  return ::kill(static_cast<pid_t>(std::stol(found[1])), 0) != 0 && errno == ESRCH;
}

}  // namespace

void write_file(std::filesystem::path const& path, std::span<char const> bytes) {
  int const file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail("cannot open", path);
  while (!bytes.empty()) {
    ssize_t const written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      int const error = errno;
      ::close(file);
      errno = error;
      fail("cannot write", path);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  if (::close(file) != 0) fail("cannot finish writing", path);
}

void sync_to_disk(std::filesystem::path const& path) {
  int const file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail("cannot open", path);
  bool const good = ::fsync(file) == 0;
  int const error = errno;
  ::close(file);
  errno = error;
  if (!good) fail("cannot hand to the disk", path);
}

void publish(std::filesystem::path const& temporary, std::filesystem::path const& path) {
  sync_to_disk(temporary);
  rename_to(temporary, path);
  sync_to_disk(path.has_parent_path() ? path.parent_path() : std::filesystem::path("."));
}

void remove_file(std::filesystem::path const& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw OutputError("cannot remove '" + path.string() + "': " + error.message());
}

void remove_files(std::filesystem::path const& folder,
                  std::function<bool(std::string const&)> const& ours) {
  std::vector<std::filesystem::path> old;
  std::error_code none;
  for (std::filesystem::directory_iterator entry(folder, none), end; !none && entry != end;
       entry.increment(none))
    if (ours(entry->path().filename().string())) old.push_back(entry->path());
  for (auto const& file : old) remove_file(file);
}

void remove_temporaries(std::filesystem::path const& folder) {
  remove_files(folder, is_left_over);
  std::error_code none;
  for (auto const& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.is_directory(none) && !entry.is_symlink(none))
      remove_files(entry.path(), is_left_over);
}

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += "." + std::to_string(::getpid()) + ".tmp";
  std::error_code ignored;  // a folder that could not be made shows when the file is opened
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), ignored);
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) fail("cannot write", temporary_);
}

AtomicFile::~AtomicFile() {
  if (committed_) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  stream_.close();
  if (!stream_) fail("cannot finish writing", temporary_);
  rename_to(temporary_, path_);
  committed_ = true;
}

}  // namespace moraine
