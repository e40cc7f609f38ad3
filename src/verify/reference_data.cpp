#include "verify/reference_data.hpp"

#include <cstdlib>

namespace moraine {

std::filesystem::path reference_file(std::string const& name, std::filesystem::path const& beside) {
  char const* const told = std::getenv("MORAINE_REFERENCE_DATA");
  std::filesystem::path const folder =
      told != nullptr ? std::filesystem::path(told) : beside.parent_path() / "shared" / "data";
  std::filesystem::path const file = folder / name;
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

std::filesystem::path reference_file(std::string const& name) {
  return reference_file(name, std::filesystem::current_path());
}

}  // namespace moraine
