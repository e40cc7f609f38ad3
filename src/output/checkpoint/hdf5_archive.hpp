// Archives in HDF5 files: one data set per piece of state, groups as the names say.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

#include "base/archive.hpp"

namespace moraine {

/// Bytes that the files leave free in front of the HDF5 data, for a seal (seal.hpp).
inline constexpr std::size_t seal_size = 512;

/// What names each piece of state once, for either direction.
using Exchange = std::function<void(Archive&)>;

/// The bytes of a file.
using FileImage = std::span<char>;

/// Makes an HDF5 file of all that `exchange` names in memory, and hands its bytes to `use`. In
/// memory, because HDF5 (1.10) does not survive a disk that fills up while it writes: it breaks off
/// the program at its end. Needs memory for the whole file. Throws std::runtime_error.
void with_hdf5_image(Exchange const& exchange, std::function<void(FileImage)> const& use);

/// Restores all that `exchange` names from a file. Throws std::runtime_error naming the file and
/// the piece that is missing, of another type, or cannot be read.
void restore_hdf5(std::filesystem::path const& path, Exchange const& exchange);

}  // namespace moraine
