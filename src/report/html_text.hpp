// Texts of users inside HTML.
#pragma once

#include <string>
#include <string_view>

namespace moraine::report {

/// The text as it stands, also inside attributes in double quotes.
inline std::string html_escaped(std::string_view text) {
  std::string out;
  for (char const c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace moraine::report
