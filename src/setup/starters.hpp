// Commented starter cases, the files of the folder starters/, as part of the program.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "base/embedded_text.hpp"

namespace moraine {

/// The files starters/*.toml; the build writes this list (cmake/MoraineTexts.cmake).
std::span<EmbeddedText const> starter_texts();

/// Writes the starter case of this kind to a file that does not exist yet. Throws InputErrors with
/// the nearest kind for an unknown one, and for a file that exists or cannot be written.
void write_starter(std::string_view kind, std::filesystem::path const& file);

}  // namespace moraine
