// Reads STL files, both kinds: text and binary.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "setup/mesh/triangle_mesh.hpp"

namespace moraine {

/// Why a file is no STL: continues a sentence that starts with its name.
class StlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The triangles of an STL file in memory, in its own unit. Normals in the file are ignored: the
/// order of the corners says where outside is.
///
/// A file is binary if its length is that of a header of 84 bytes and 50 bytes for each triangle of
/// the count in it, whatever it begins with, and text if it begins with "solid". The count in the
/// header is never trusted beyond the length. Text may hold several solids.
///
/// Throws StlError for a file that is cut off or of another kind, for text that breaks the grammar
/// (with the line), for coordinates that are no finite numbers and for a file without triangles.
std::vector<Triangle> parse_stl(std::string_view bytes);

/// The same for a file. Throws StlError too if it cannot be read or exceeds 2 GiB.
std::vector<Triangle> read_stl(std::filesystem::path const& path);

}  // namespace moraine
