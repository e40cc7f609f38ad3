// From a case file to a Case.
#pragma once

#include <filesystem>
#include <string_view>

#include "setup/case.hpp"

namespace moraine {

/// Reads and checks a case file. Throws InputErrors with all mistakes of the file: unknown and
/// missing keys, wrong types, units, ranges and names, and values that contradict each other. Only
/// a syntax error hides the others. A file that cannot be opened is an InputErrors too.
Case read_case(std::filesystem::path const& path);

/// The same for text in memory; `file_name` is used in messages and kept as Case::file.
Case parse_case(std::string_view text, std::string_view file_name);

}  // namespace moraine
