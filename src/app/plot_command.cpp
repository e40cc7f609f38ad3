// moraine plot: pictures of a run folder.
#include <fmt/format.h>

#include <filesystem>

#include "app/commands.hpp"
#include "output/plot/plot.hpp"

namespace moraine {

int plot_folder(PlotOptions const& options) {
  std::filesystem::path const folder = options.folder;
  for (auto const& file : plot_run(folder, folder / "plots", options.field))
    fmt::print("{}\n", file.string());
  return ExitCode::done;
}

}  // namespace moraine
