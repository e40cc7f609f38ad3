// Texts of users on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace moraine {

/// The text with a question mark for every control character: a case from elsewhere must not move
/// the cursor, recolour or rename the terminal that it is run in.
inline std::string printable(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    auto const c = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F, as UTF-8, are control characters too.
    bool const second =
        c == 0xC2U && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xA0U;
    if (second) ++i;
    out += c < 0x20U || c == 0x7FU || second ? '?' : text[i];
  }
  return out;
}

}  // namespace moraine
