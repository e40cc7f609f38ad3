// Where the sources and the built program lie.
#pragma once

#include <string>

namespace moraine {

/// The folder of the repository, without a slash at its end.
std::string source_folder();

/// The program `moraine` of this build.
char const* program_file();

}  // namespace moraine
