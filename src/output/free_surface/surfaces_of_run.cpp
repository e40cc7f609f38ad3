#include "output/free_surface/surfaces_of_run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <regex>

#include "base/input_error.hpp"
#include "output/free_surface/contour_writer.hpp"
#include "output/pvd_collection.hpp"
#include "output/vtp_reader.hpp"
#include "setup/read_case.hpp"

namespace moraine {
namespace {

[[noreturn]] void refuse(std::string key, std::string value, std::string rule,
                         std::string hint = {}) {
  throw InputErrors({{"moraine surface", 0, 0, std::move(key), std::move(value), std::move(rule),
                      std::move(hint)}});
}

std::vector<PvdEntry> frames_of(std::filesystem::path const& run) {
  if (!std::filesystem::exists(run / "particles.pvd") ||
      !std::filesystem::exists(run / "case.used.toml"))
    refuse("folder", fmt::format("\"{}\"", run.string()), "holds no frames of a run",
           "name the folder of results of moraine run");
  return read_pvd(run / "particles.pvd");
}

std::vector<std::size_t> chosen_frames(std::size_t count, SurfaceChoice const& choice) {
  if (count == 0) refuse("folder", "", "holds no frames");
  if (choice.frame && *choice.frame >= count)
    refuse("--frame", std::to_string(*choice.frame),
           fmt::format("is no frame of this run: there are 0 to {}", count - 1));
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k < count; ++k)
    if (choice.all || k == choice.frame.value_or(count - 1)) frames.push_back(k);
  return frames;
}

/// The number of the material; none where all count.
std::optional<double> material_number(Case const& c, std::string const& name) {
  if (name.empty()) return std::nullopt;
  std::vector<std::string_view> names;
  for (MaterialSpec const& material : c.materials) names.push_back(material.name);
  auto const found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    refuse("--material", fmt::format("\"{}\"", name), "is not a material of this run",
           name_hint(name, names));
  return static_cast<double>(found - names.begin());
}

Blobs blobs_of(ParticleFrame const& frame, std::optional<double> material, double h,
               std::filesystem::path const& path) {
  FrameArray const* const mass = frame.find("mass");
  FrameArray const* const density = frame.find("density");
  FrameArray const* const of = frame.find("material");
  FrameArray const* const lengths = frame.find("smoothing_length");
  if (mass == nullptr || density == nullptr || of == nullptr)
    refuse("folder", fmt::format("\"{}\"", path.string()),
           "has no arrays mass, density and material");
  Blobs blobs;
  blobs.dimension = frame.dimension;
  for (std::size_t i = 0; i < frame.size; ++i) {
    if (material && of->values[i] != *material) continue;
    auto const* const x = &frame.points.values[3 * i];
    double const volume = mass->values[i] / density->values[i];
    double const length = lengths != nullptr ? lengths->values[i] : h;
    bool const sound = std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]) &&
                       std::isfinite(volume) && length > 0.0 && std::isfinite(length);
    if (!sound) continue;  // of a run that broke down
    blobs.place.push_back({x[0], x[1], x[2]});
    blobs.volume.push_back(volume);
    blobs.h.push_back(length);
  }
  return blobs;
}

std::string name_for_files(std::string const& material) {
  if (material.empty()) return "surface";
  std::string name = material;
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0 && letter != '-') letter = '_';
  return name;
}

}  // namespace

std::vector<std::filesystem::path> write_surfaces(std::filesystem::path const& run,
                                                  SurfaceChoice const& choice) {
  auto const frames = frames_of(run);
  Case const c = read_case(run / "case.used.toml");
  if (c.dimension == 1) refuse("folder", "", "holds a 1D run, which has no surface to draw");
  auto const material = material_number(c, choice.material);
  auto const folder = run / "surfaces";
  std::string const name = name_for_files(choice.material);
  double const h = c.numerics.smoothing_length();
  std::vector<std::filesystem::path> written;
  std::vector<PvdEntry> entries;
  for (std::size_t const k : chosen_frames(frames.size(), choice)) {
    auto const path = run / frames[k].file;
    Blobs const blobs = blobs_of(read_vtp(path), material, h, path);
    NodeGrid const grid = filled_grid(blobs, c.numerics.kernel, 0.5 * h);
    entries.push_back({frames[k].time, fmt::format("{}_{:06}.vtp", name, k)});
    written.push_back(folder / entries.back().file);
    write_contour(written.back(), contour_at(grid, choice.share), frames[k].time);
  }
  written.push_back(folder / (name + ".pvd"));
  PvdCollection(written.back(), entries).write();
  return written;
}

bool is_surface_of_run(std::string const& file_name) {
  static std::regex const ours("[A-Za-z0-9_-]+(_[0-9]{6,}\\.vtp|\\.pvd)");
  return std::regex_match(file_name, ours);
}

}  // namespace moraine
