// The files of report/dist, built into the program.
#pragma once

#include <span>

#include "base/embedded_text.hpp"

namespace moraine {

/// "page": the page without data; "player": what shows particles (report/FORMAT.md).
std::span<EmbeddedText const> report_assets();

}  // namespace moraine
