// moraine plot: pictures of a run folder.
#include <fmt/core.h>

#include <filesystem>
#include <stdexcept>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "output/plot/plot.hpp"

namespace moraine {

int plot_folder(PlotOptions const& options) {
  std::filesystem::path const folder = options.folder;
  try {
    for (auto const& file : plot_run(folder, folder / "plots", options.field))
      fmt::print("{}\n", file.string());
  } catch (std::invalid_argument const& error) {
    throw InputErrors({{"moraine plot", 0, 0, "--field", "", error.what(), ""}});
  }
  return ExitCode::done;
}

}  // namespace moraine
