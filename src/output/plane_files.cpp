#include "output/plane_files.hpp"

#include <fmt/core.h>

#include <charconv>
#include <regex>

#include "output/atomic_file.hpp"

namespace moraine {

std::string plane_file(std::string const& plane, std::size_t number) {
  return fmt::format("{}_{:06}.vti", plane, number);
}

void drop_planes(std::filesystem::path const& folder, std::size_t first) {
  static std::regex const ours("[A-Za-z0-9_-]+_([0-9]{6,})\\.vti");
  static std::regex const collections("[A-Za-z0-9_-]+\\.pvd");
  remove_files(folder / "planes", [&](std::string const& name) {
    std::smatch match;
    if (!std::regex_match(name, match, ours))
      return first == 0 && std::regex_match(name, collections);
    std::string const digits = match[1];
    std::size_t number = 0;
    auto const end = digits.data() + digits.size();
    auto const [ignored, error] = std::from_chars(digits.data(), end, number);
    return error == std::errc{} && number >= first;
  });
}

}  // namespace moraine
