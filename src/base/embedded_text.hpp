// Files of the repository that are part of the program (cmake/MoraineTexts.cmake).
#pragma once

#include <string_view>

namespace moraine {

/// A text file as it was when the program was built.
struct EmbeddedText {
  std::string_view name;  // of the file, without its ending; of a case, that of its folder
  std::string_view text;
};

}  // namespace moraine
