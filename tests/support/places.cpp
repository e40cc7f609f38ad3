#include "support/places.hpp"

namespace moraine {

std::string source_folder() { return MORAINE_SOURCE_DIR; }

char const* program_file() { return MORAINE_PROGRAM; }

}  // namespace moraine
