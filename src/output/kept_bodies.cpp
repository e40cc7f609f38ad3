#include "output/kept_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

#include "base/input_error.hpp"
#include "output/atomic_file.hpp"
#include "output/output_error.hpp"
#include "output/sha256.hpp"

namespace moraine {
namespace {

/// Calls `visit` for every STL body of a shape tree or region.
template <class Tree, class Visit>
void for_each_body(Tree& tree, Visit const& visit) {
  if (auto* body = std::get_if<StlBody>(&tree.shape)) visit(*body);
  for (auto& part : tree.plus) for_each_body(part, visit);
  for (auto& part : tree.minus) for_each_body(part, visit);
}

std::string bytes_of(std::filesystem::path const& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad())
    throw OutputError(fmt::format("cannot copy '{}': it cannot be read", path.string()));
  return bytes;
}

bool is_kept_name(std::string const& name) {
  return name.size() == 68 && name.ends_with(".stl") &&
         name.find_first_not_of("0123456789abcdef") == 64;
}

}  // namespace

Case with_kept_bodies(Case c, std::filesystem::path const& folder) {
  for (auto& region : c.regions)
    for_each_body(region, [&](StlBody& body) {
      std::string const bytes = bytes_of(body.file);
      std::string const name = "bodies/" + sha256(bytes) + ".stl";
      if (!std::filesystem::exists(folder / name)) {
        AtomicFile copy(folder / name);
        copy.stream() << bytes;
        copy.commit();
      }
      body.file = name;
    });
  return c;
}

void check_kept_bodies(Case const& c, std::filesystem::path const& folder) {
  std::error_code ignored;
  auto const kept = std::filesystem::absolute(folder / "bodies", ignored).lexically_normal();
  std::vector<InputProblem> problems;
  for (auto const& region : c.regions)
    for_each_body(region, [&](StlBody const& body) {
      std::filesystem::path const file = body.file;
      if (file.parent_path() != kept || sha256(bytes_of(file)) == file.stem()) return;
      problems.push_back({file.string(), 0, 0, "", "", "has changed since the run began",
                          "put the file back that it was copied from, or start again"});
    });
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

void drop_kept_bodies(std::filesystem::path const& folder) {
  remove_files(folder / "bodies", is_kept_name);
}

}  // namespace moraine
