#include "verify/shipped_cases.hpp"

#include <stdexcept>
#include <string>

#include "setup/read_case.hpp"

namespace moraine {

Case shipped_case(std::string_view name) {
  for (EmbeddedText const& shipped : shipped_cases())
    if (shipped.name == name)
      return parse_case(shipped.text, "cases/" + std::string(name) + "/case.toml");
  throw std::invalid_argument("no case of this name is part of the program: " + std::string(name));
}

}  // namespace moraine
