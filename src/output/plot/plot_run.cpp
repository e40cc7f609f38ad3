#include <fmt/core.h>

#include <algorithm>
#include <regex>
#include <utility>

#include "base/input_error.hpp"
#include "output/plot/color_bar.hpp"
#include "output/plot/drawable.hpp"
#include "output/plot/frame_field.hpp"
#include "output/plot/plot.hpp"
#include "output/pvd_collection.hpp"
#include "output/table_csv.hpp"
#include "output/vtp_reader.hpp"

namespace moraine {
namespace {

constexpr std::size_t most_frames = 5;

/// Up to `most_frames` of `count` frames, evenly spread, first and last included.
std::vector<std::size_t> chosen_frames(std::size_t count) {
  std::vector<std::size_t> chosen;
  std::size_t const wanted = std::min(count, most_frames);
  for (std::size_t i = 0; i < wanted; ++i)
    chosen.push_back(wanted == 1 ? 0 : i * (count - 1) / (wanted - 1));
  return chosen;
}

InputErrors bad_folder(std::filesystem::path const& folder, std::string rule) {
  return InputErrors({{"moraine plot", 0, 0, "folder", fmt::format("\"{}\"", folder.string()),
                       std::move(rule), "give the folder that \"moraine run\" has written"}});
}

/// One scale for all pictures of a run, so that they can be compared; nothing for profiles.
std::optional<std::array<double, 2>> range_of_frames(
    std::vector<std::filesystem::path> const& frames, std::string const& field) {
  std::vector<plot::ColorRange> ranges;
  for (auto const& file : frames) {
    ParticleFrame const frame = plot::read_drawable_frame(file);
    if (frame.dimension == 1) return std::nullopt;
    ranges.push_back(plot::color_range(plot::frame_field(frame, field).values));
  }
  if (ranges.empty()) return std::nullopt;
  plot::ColorRange const common = plot::common_range(ranges);
  return std::array{common.low, common.high};
}

}  // namespace

bool is_picture_of_run(std::string const& file_name) {
  static std::regex const pattern("(histories|sums)\\.(svg|png)|[a-z_]+_particles_[0-9]{6,}\\.png");
  return std::regex_match(file_name, pattern);
}

std::vector<std::filesystem::path> plot_run(std::filesystem::path const& run,
                                            std::filesystem::path const& out,
                                            std::string const& field) {
  if (!std::filesystem::is_directory(run))
    throw bad_folder(run, std::filesystem::exists(run) ? "is no run folder but a file"
                                                       : "is no run folder: it does not exist");
  std::vector<std::filesystem::path> written;
  auto const series = [&](char const* table, char const* name, auto draw) {
    if (!std::filesystem::exists(run / table)) return;
    Table const contents = read_table_csv(run / table);
    if (contents.rows() == 0 || contents.columns.size() < 2) return;  // a case without gauges
    for (char const* ending : {"svg", "png"}) {
      written.push_back(out / fmt::format("{}.{}", name, ending));
      draw(run / table, written.back());
    }
  };
  series("gauges.csv", "histories", plot_histories);
  series("sums.csv", "sums", plot_sums);

  if (std::filesystem::exists(run / "particles.pvd")) {
    std::vector<PvdEntry> const entries = read_pvd(run / "particles.pvd");
    FramePlotOptions options;
    if (std::filesystem::exists(run / "walls.vtp")) options.walls = run / "walls.vtp";
    std::vector<std::filesystem::path> frames;
    for (std::size_t const i : chosen_frames(entries.size()))
      frames.push_back(run / entries[i].file);
    options.range = range_of_frames(frames, field);
    for (auto const& frame : frames) {
      written.push_back(out / fmt::format("{}_{}.png", field, frame.stem().string()));
      auto const moved = frame.parent_path() / frame.filename().string().replace(0, 9, "walls");
      if (std::filesystem::exists(moved)) options.walls = moved;
      if (!options.range)
        plot_profile(frame, field, written.back());
      else
        plot_frame(frame, field, written.back(), options);
    }
  }
  if (written.empty())
    throw bad_folder(run,
                     "has nothing to plot: no gauges.csv, sums.csv or particles.pvd with frames");
  return written;
}

}  // namespace moraine
