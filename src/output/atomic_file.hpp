// A file that appears complete or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>

namespace moraine {

/// Writes to `<path>.tmp` and renames it to `path` on commit, so that a reader (or a killed run)
/// never meets half a file. Missing parent folders are made. Without commit the temporary file is
/// removed. Throws std::runtime_error naming the path when opening, writing or renaming fails.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(AtomicFile const&) = delete;
  AtomicFile& operator=(AtomicFile const&) = delete;

  std::ostream& stream() { return stream_; }
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
  bool committed_ = false;
};

}  // namespace moraine
