// Archives in HDF5 files: one data set per piece of state, groups as the names say.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "base/archive.hpp"

namespace moraine {

/// Bytes that the files leave free in front of the HDF5 data, for a seal (seal.hpp).
inline constexpr std::size_t seal_size = 512;

/// What names each piece of state once, for either direction.
using Exchange = std::function<void(Archive&)>;

/// Writes all that `exchange` names to a file, replacing one that is there. Throws
/// std::runtime_error, with the system's words (disk full), when something cannot be written.
void save_hdf5(std::filesystem::path const& path, Exchange const& exchange);

/// Restores all that `exchange` names from a file. Throws std::runtime_error naming the file and
/// the piece that is missing, of another type, or cannot be read.
void restore_hdf5(std::filesystem::path const& path, Exchange const& exchange);

}  // namespace moraine
