#include "output/atomic_file.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace moraine {
namespace {

[[noreturn]] void fail(char const* what, std::filesystem::path const& path) {
  throw std::runtime_error(std::string(what) + " '" + path.string() + "': " + std::strerror(errno));
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), temporary_(path_) {
  temporary_ += ".tmp";
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
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error)
    throw std::runtime_error("cannot rename '" + temporary_.string() + "' to '" + path_.string() +
                             "': " + error.message());
  committed_ = true;
}

}  // namespace moraine
