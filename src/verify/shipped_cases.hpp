// The case files of the folder cases/, as part of the program.
#pragma once

#include <span>
#include <string_view>

#include "setup/case.hpp"

namespace moraine {

/// A case file as it was when the program was built.
struct ShippedCase {
  std::string_view name;  // of its folder in cases/
  std::string_view text;
};

/// All of them, sorted by name; the build writes this list (cmake/MoraineCases.cmake).
std::span<ShippedCase const> shipped_cases();

/// The case cases/NAME/case.toml. Throws std::invalid_argument for an unknown name, InputErrors for
/// a file that does not read.
Case shipped_case(std::string_view name);

}  // namespace moraine
