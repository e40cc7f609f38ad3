// Files that appear complete or not at all.
#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <span>
#include <string>

namespace moraine {

/// Writes a file. Throws OutputError naming the path, with the system's words (disk full).
void write_file(std::filesystem::path const& path, std::span<char const> bytes);

/// Waits until a file's content, or a folder's list of files, is on the disk (fsync). Throws
/// OutputError naming the path.
void sync_to_disk(std::filesystem::path const& path);

/// Renames a finished file so that after a loss of power there is the old file or the whole new
/// one: content first, then name, then folder are handed to the disk. Throws OutputError.
void publish(std::filesystem::path const& temporary, std::filesystem::path const& path);

/// Removes a file, if it is there. Throws OutputError naming the path.
void remove_file(std::filesystem::path const& path);

/// Removes the files of a folder whose names are `ours`; a folder that is not there has none.
/// Throws OutputError naming the file that stays.
void remove_files(std::filesystem::path const& folder,
                  std::function<bool(std::string const&)> const& ours);

/// Removes what killed processes have left of their AtomicFiles in a folder and in the folders
/// right in it. Throws OutputError naming the file that stays.
void remove_temporaries(std::filesystem::path const& folder);

/// Writes to `<path>.<process>.tmp` and renames it to `path` on commit, so that a reader (or a
/// killed run) never meets half a file, and that of two processes which write the same file one
/// wins. Missing parent folders are made. Without commit the temporary file is removed. Throws
/// OutputError naming the path when opening, writing or renaming fails.
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
