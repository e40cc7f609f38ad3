#include "output/kept_files.hpp"

#include <fmt/core.h>

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

/// Where copies of a kind of file are kept, and how their names end.
struct Keep {
  std::string_view folder, ending;
};
constexpr Keep body_keep{"bodies", ".stl"};
constexpr Keep motion_keep{"motions", ".csv"};
constexpr Keep reference_keep{"references", ".csv"};

/// Calls visit(name of the file, where it is kept) for every file that the case names.
template <class AnyCase, class Visit>
void for_each_file(AnyCase& c, Visit const& visit) {
  for (auto& region : c.regions)
    for_each_body(region, [&](auto& body) { visit(body.file, body_keep); });
  for (auto& wall : c.walls)
    if (!wall.motion.file.empty()) visit(wall.motion.file, motion_keep);
  for (auto& reference : c.references)
    if (!reference.file.empty()) visit(reference.file, reference_keep);
}

bool is_kept_name(std::string const& name, Keep const& keep) {
  return name.size() == 64 + keep.ending.size() && name.ends_with(keep.ending) &&
         name.find_first_not_of("0123456789abcdef") == 64;
}

}  // namespace

Case with_kept_files(Case c, std::filesystem::path const& folder) {
  for_each_file(c, [&](std::string& file, Keep const& keep) {
    std::string const bytes = bytes_of(file);
    std::string const name = fmt::format("{}/{}{}", keep.folder, sha256(bytes), keep.ending);
    if (!std::filesystem::exists(folder / name)) {
      AtomicFile copy(folder / name);
      copy.stream() << bytes;
      copy.commit();
    }
    file = name;
  });
  return c;
}

void check_kept_files(Case const& c, std::filesystem::path const& folder) {
  std::error_code ignored;
  std::vector<InputProblem> problems;
  for_each_file(c, [&](std::string const& name, Keep const& keep) {
    std::filesystem::path const file = name;
    auto const kept = std::filesystem::absolute(folder / keep.folder, ignored).lexically_normal();
    if (file.parent_path() != kept || sha256(bytes_of(file)) == file.stem()) return;
    problems.push_back({file.string(), 0, 0, "", "", "has changed since the run began",
                        "put the file back that it was copied from, or start again"});
  });
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

void drop_kept_files(std::filesystem::path const& folder) {
  for (Keep const& keep : {body_keep, motion_keep, reference_keep})
    remove_files(folder / keep.folder,
                 [&](std::string const& name) { return is_kept_name(name, keep); });
}

}  // namespace moraine
