// Copies of the files that a case names - STL bodies, motions, reference curves - in the folder of
// its run, which then depends on no other place.
#pragma once

#include <filesystem>

#include "setup/case.hpp"

namespace moraine {

/// The case as it reads from the folder of its run: files are named "bodies/DIGEST.stl" and
/// "motions/DIGEST.csv", "references/DIGEST.csv", with the SHA-256 of the file, relative to the
/// folder. Files that are not there yet are copied. Throws OutputError if a file cannot be read or
/// its copy not be written.
Case with_kept_files(Case c, std::filesystem::path const& folder);

/// Throws InputErrors for every such copy whose content no longer fits its name.
void check_kept_files(Case const& c, std::filesystem::path const& folder);

/// Removes the copies of an earlier run. Throws OutputError.
void drop_kept_files(std::filesystem::path const& folder);

}  // namespace moraine
