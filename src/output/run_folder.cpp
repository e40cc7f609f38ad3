#include "output/run_folder.hpp"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <system_error>

#include "output/atomic_file.hpp"
#include "output/bad_frame.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/free_surface/surfaces_of_run.hpp"
#include "output/kept_files.hpp"
#include "output/output_error.hpp"
#include "output/plane_files.hpp"
#include "output/plot/plot.hpp"

namespace moraine {
namespace {

using Json = nlohmann::json;

/// No object where there is none or it is damaged.
Json manifest_of(std::filesystem::path const& folder) {
  std::ifstream file(folder / "manifest.json");
  return Json::parse(file, nullptr, false);
}

/// Empty where there is no such text.
std::string text_in(Json const& json, char const* key) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_string()) return {};
  return json[key].get<std::string>();
}

void drop_snapshots(std::filesystem::path const& folder) {
  static std::regex const ours("(particles|walls)_at_step_[0-9]{9,}\\.vtp");
  remove_files(folder / "snapshots",
               [](std::string const& name) { return std::regex_match(name, ours); });
}

}  // namespace

bool holds_a_run(std::filesystem::path const& folder) {
  return std::filesystem::exists(folder / "manifest.json");
}

bool has_written_its_end(std::filesystem::path const& folder) {
  return text_in(manifest_of(folder), "state") == "ended";
}

bool has_results_of(std::filesystem::path const& folder, std::string const& case_sha256,
                    BuildInfo const& build) {
  Json const manifest = manifest_of(folder);
  return text_in(manifest, "case_sha256") == case_sha256 &&
         text_in(manifest, "version") == build.version &&
         text_in(manifest, "git_revision") == build.git_revision && manifest.contains("end") &&
         text_in(manifest["end"], "reason") == "end time reached";
}

void make_run_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder / "frames", error);
  if (error)
    throw OutputError(
        fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  drop_frames(folder, 0);
  Checkpoints(folder).forget();
  remove_file(folder / start_copy);
  drop_kept_files(folder);
  drop_snapshots(folder);
  for (char const* const name : {"stop", "snapshot", "status.json", "report.html"})
    remove_file(folder / name);
}

std::string frame_name(std::size_t number) {
  return fmt::format("frames/particles_{:06}.vtp", number);
}

std::string wall_frame_name(std::size_t number) {
  return fmt::format("frames/walls_{:06}.vtp", number);
}

std::string snapshot_name(std::uint64_t step) {
  return fmt::format("snapshots/particles_at_step_{:09}.vtp", step);
}

std::string wall_snapshot_name(std::uint64_t step) {
  return fmt::format("snapshots/walls_at_step_{:09}.vtp", step);
}

void drop_frames(std::filesystem::path const& folder, std::size_t first) {
  static std::regex const particles("particles_[0-9]{6,}\\.vtp");
  static std::regex const walls("walls_[0-9]{6,}\\.vtp");
  remove_files(folder / "frames", [&](std::string const& name) {
    if (std::regex_match(name, walls)) return "frames/" + name >= wall_frame_name(first);
    return std::regex_match(name, particles) && "frames/" + name >= frame_name(first);
  });
  remove_temporaries(folder);
  if (first == 0) remove_file(folder / "walls.pvd");
  drop_planes(folder, first);
  remove_files(folder / "plots", is_picture_of_run);
  remove_files(folder / "surfaces", is_surface_of_run);
  drop_bad_frame(folder);
}

}  // namespace moraine
