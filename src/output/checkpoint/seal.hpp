// A seal on a file: a checksum in front that shows any change of any byte.
#pragma once

#include <filesystem>
#include <string>

#include "output/checkpoint/hdf5_archive.hpp"

namespace moraine {

/// Writes the seal into the first seal_size bytes of a file's content, which its own format leaves
/// free: a line of text with the length of the file and the 128-bit XXH3 checksum of the rest,
/// padded with blanks.
void seal(FileImage file);

/// Why a file cannot be trusted: not there, no seal, another length, another checksum. Empty when
/// every byte is as it was sealed.
std::string broken_seal(std::filesystem::path const& path);

}  // namespace moraine
