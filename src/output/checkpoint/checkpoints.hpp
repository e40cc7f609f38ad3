// The checkpoints of a run: files from which it can go on as if it had never stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/checkpoint/hdf5_archive.hpp"

namespace moraine {

/// A folder `checkpoints` with the two newest states of a run, `step_000000001234.h5`.
///
/// A state is written beside them under another name, sealed (seal.hpp), handed to the disk and
/// then renamed, so at any moment at least one whole state is there once there has been one. Files
/// are plain HDF5 and can be looked at with h5dump.
class Checkpoints {
 public:
  explicit Checkpoints(std::filesystem::path const& run_folder)
      : folder_(run_folder / "checkpoints") {}

  /// Saves all that `exchange` names as the state after a step, and drops all but the two newest.
  /// Throws OutputError when it cannot be written (disk full); older states are then intact
  /// and no piece of a file is left behind.
  void save(std::uint64_t step, Exchange const& exchange);

  /// Newest state whose seal is whole; nothing if there is none. What was passed over, and why, is
  /// added to `skipped`.
  std::optional<std::filesystem::path> newest(std::vector<std::string>& skipped) const;

  /// Removes all states, also unfinished ones. Throws OutputError.
  void forget() const;

  /// Removes the states after this one, also unfinished ones. Throws OutputError.
  void forget_newer(std::filesystem::path const& last) const;

 private:
  std::vector<std::filesystem::path> files() const;  // newest first

  std::filesystem::path folder_;
};

}  // namespace moraine
