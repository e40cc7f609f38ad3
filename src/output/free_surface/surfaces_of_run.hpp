// Free surfaces of the frames of a run.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moraine {

struct SurfaceChoice {
  std::optional<std::size_t> frame;  // number of the frame; none: the last one
  bool all = false;                  // all frames
  std::string material;              // empty: the particles of all materials
  double share = 0.5;                // of the kernel that is filled at the surface
};

/// Draws the surface sum_j V_j W(x - x_j) = share of frames of a run, V = m / rho, with the kernel
/// and the smoothing length of the case (of the particles, where it varies), on a grid of cells
/// half a smoothing length wide, and writes it to surfaces/NAME_000000.vtp ... in the folder, with
/// the collection surfaces/NAME.pvd; NAME is `surface`, or that of the material with other
/// characters than letters, digits, - and _ replaced by _. Surfaces are closed, also at walls and
/// at the sides of the domain. Returns the files written. Throws InputErrors where the folder holds
/// no frames, or not this one, or where the case does not have the material or is 1D.
std::vector<std::filesystem::path> write_surfaces(std::filesystem::path const& run,
                                                  SurfaceChoice const& choice);

/// Whether write_surfaces gives a file this name.
bool is_surface_of_run(std::string const& file_name);

}  // namespace moraine
