#include "output/checkpoint/checkpoints.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <system_error>

#include "output/atomic_file.hpp"
#include "output/checkpoint/seal.hpp"
#include "output/output_error.hpp"

namespace moraine {
namespace {

constexpr std::size_t kept = 2;

bool is_ours(std::string const& name) {
  return name.starts_with("step_") && (name.ends_with(".h5") || name.ends_with(".h5.tmp"));
}

}  // namespace

std::vector<std::filesystem::path> Checkpoints::files() const {
  std::vector<std::filesystem::path> found;
  std::error_code none;
  for (auto const& entry : std::filesystem::directory_iterator(folder_, none)) {
    std::string const name = entry.path().filename().string();
    if (is_ours(name) && name.ends_with(".h5")) found.push_back(entry.path());
  }
  // Steps have twelve digits, so the order of the names is that of the steps.
  std::sort(found.begin(), found.end(), std::greater<>());
  return found;
}

void Checkpoints::save(std::uint64_t step, Exchange const& exchange) {
  std::filesystem::path const path = folder_ / fmt::format("step_{:012}.h5", step);
  std::filesystem::path temporary = path;
  temporary += ".tmp";
  try {
    std::filesystem::create_directories(folder_);
    with_hdf5_image(exchange, [&](FileImage image) {
      seal(image);
      write_file(temporary, image);
    });
    publish(temporary, path);
  } catch (std::exception const& error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw OutputError(fmt::format("no checkpoint of step {}: {}", step, error.what()));
  }
  auto const all = files();
  for (std::size_t k = kept; k < all.size(); ++k) remove_file(all[k]);
}

std::optional<std::filesystem::path> Checkpoints::newest(std::vector<std::string>& skipped) const {
  for (auto const& file : files()) {
    std::string const why = broken_seal(file);
    if (why.empty()) return file;
    skipped.push_back(fmt::format("{} {}", file.string(), why));
  }
  return std::nullopt;
}

void Checkpoints::forget() const { forget_newer(folder_); }

void Checkpoints::forget_newer(std::filesystem::path const& last) const {
  remove_files(folder_,
               [&](std::string const& name) { return is_ours(name) && folder_ / name > last; });
}

}  // namespace moraine
