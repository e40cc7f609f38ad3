#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

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

}  // namespace

std::vector<std::filesystem::path> plot_run(std::filesystem::path const& run,
                                            std::filesystem::path const& out,
                                            std::string const& field) {
  if (!std::filesystem::is_directory(run))
    throw std::runtime_error(fmt::format("no run folder '{}'", run.string()));
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
    for (std::size_t const i : chosen_frames(entries.size())) {
      std::filesystem::path const frame = run / entries[i].file;
      written.push_back(out / fmt::format("{}_{}.png", field, frame.stem().string()));
      if (read_vtp(frame).dimension == 1)
        plot_profile(frame, field, written.back());
      else
        plot_frame(frame, field, written.back(), options);
    }
  }
  if (written.empty())
    throw std::runtime_error(
        fmt::format("nothing to plot in '{}': no gauges.csv, sums.csv or particles.pvd with frames",
                    run.string()));
  return written;
}

}  // namespace moraine
