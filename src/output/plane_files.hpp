// The files of the planes of a run.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace moraine {

/// Name of a plane's file that belongs to the frame of this number, in the folder `planes`.
std::string plane_file(std::string const& plane, std::size_t number);

/// Removes the files of planes that belong to frames from this number on; collections go with the
/// first one. Throws OutputError.
void drop_planes(std::filesystem::path const& folder, std::size_t first);

}  // namespace moraine
