// The case files of the folder cases/, as part of the program.
#pragma once

#include <span>
#include <string_view>

#include "base/embedded_text.hpp"
#include "setup/case.hpp"

namespace moraine {

/// All of them, sorted by name, that of their folder; the build writes this list
/// (cmake/MoraineTexts.cmake).
std::span<EmbeddedText const> shipped_cases();

/// The case cases/NAME/case.toml. Throws std::invalid_argument for an unknown name, InputErrors for
/// a file that does not read.
Case shipped_case(std::string_view name);

}  // namespace moraine
