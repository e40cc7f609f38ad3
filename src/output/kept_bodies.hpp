// Copies of the STL files of a case in the folder of its run, which then depends on no other place.
#pragma once

#include <filesystem>

#include "setup/case.hpp"

namespace moraine {

/// The case as it reads from the folder of its run: names of STL files are "bodies/DIGEST.stl",
/// with the SHA-256 of the file as its name, relative to the folder. Files that are not there yet
/// are copied. Throws OutputError if a file cannot be read or its copy not be written.
Case with_kept_bodies(Case c, std::filesystem::path const& folder);

/// Throws InputErrors for every STL file of a case below folder/bodies whose content no longer fits
/// its name.
void check_kept_bodies(Case const& c, std::filesystem::path const& folder);

/// Removes the copies of an earlier run. Throws OutputError.
void drop_kept_bodies(std::filesystem::path const& folder);

}  // namespace moraine
