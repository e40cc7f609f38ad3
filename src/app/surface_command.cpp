// moraine surface: the free surface of the frames of a run.
#include <fmt/core.h>

#include "app/commands.hpp"
#include "output/free_surface/surfaces_of_run.hpp"

namespace moraine {

int draw_surfaces(SurfaceOptions const& options) {
  SurfaceChoice choice{std::nullopt, options.all, options.material, options.share};
  if (options.frame >= 0) choice.frame = static_cast<std::size_t>(options.frame);
  for (auto const& file : write_surfaces(options.folder, choice)) fmt::print("{}\n", file.string());
  return ExitCode::done;
}

}  // namespace moraine
