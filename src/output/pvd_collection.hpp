// The list of frames with their times, which ParaView opens as one animation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moraine {

/// One frame: time [s] and file, relative to the folder of the collection.
struct PvdEntry {
  double time = 0.0;
  std::string file;
};

/// Writes a `.pvd` that is complete after every frame: a run that is killed can be looked at up to
/// its last frame.
class PvdCollection {
 public:
  /// `entries`: frames that are there already (for a run that goes on from a checkpoint).
  explicit PvdCollection(std::filesystem::path path, std::vector<PvdEntry> entries = {});

  std::vector<PvdEntry> const& entries() const { return entries_; }

  /// Adds a frame and rewrites the file. Throws OutputError if it cannot be written.
  void add(double time, std::string file);

  /// Writes the file with the frames as they are.
  void write() const;

 private:
  std::filesystem::path path_;
  std::vector<PvdEntry> entries_;
};

/// Reads a collection. Throws std::runtime_error for a missing or malformed file.
std::vector<PvdEntry> read_pvd(std::filesystem::path const& path);

}  // namespace moraine
