// Pictures of a run for papers and for a first look: SVG or PNG by file ending.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moraine {

/// Gauge histories over time: one panel per quantity, one line per gauge. The first column of the
/// table is the time; the others are named `<gauge> <quantity> [unit]`.
/// Throws std::runtime_error for a missing or malformed table or one without rows.
void plot_histories(std::filesystem::path const& csv, std::filesystem::path const& out);

/// Conserved sums over time: changes of the energies since the start, the change of their total
/// relative to the energy exchanged between them (the energy error), momentum, and the time step.
/// Throws as plot_histories, and if a column is missing.
void plot_sums(std::filesystem::path const& csv, std::filesystem::path const& out);

struct FramePlotOptions {
  std::optional<std::array<double, 2>> range;  // of the colours, SI; default: of the values
  std::filesystem::path walls;                 // .vtp of wall particles, drawn grey; may be empty
};

/// Particles of one frame as coloured dots that touch, with a colour bar. 2D frames show x and y,
/// 3D frames are looked at along +y (x to the right, z upwards), nearer particles in front, walls
/// behind. `field`: a scalar, a vector (its magnitude is shown) or a component as in "velocity_x".
/// Without a given range the colours span all values, unless one in a thousand at either end would
/// stretch the range more than threefold: then these are cut off, which the colour bar shows.
/// More than 20 000 particles become a picture also inside SVG.
/// Throws std::runtime_error for unreadable files, std::invalid_argument for an unknown field (the
/// message lists the valid ones) and for a 1D frame.
void plot_frame(std::filesystem::path const& vtp, std::string const& field,
                std::filesystem::path const& out, FramePlotOptions const& options = {});

/// Value against x for all particles of a frame; for 1D frames the points are joined.
/// `field` and errors as in plot_frame.
void plot_profile(std::filesystem::path const& vtp, std::string const& field,
                  std::filesystem::path const& out);

/// All pictures of a run folder: histories and sums (SVG and PNG) where their tables are, and up to
/// five frames spread over the run, the last one included (PNG), as profiles in 1D.
/// The colours of all frames have one scale: from the middle of the low ends to the middle of the
/// high ends that plot_frame would choose for the single frames (of two middle ones the wider), so
/// that one extreme frame does not darken the others; values beyond show at the colour bar.
/// Returns the files written. Throws InputErrors if `run` is no folder or holds nothing to plot,
/// and whatever the single plots throw.
std::vector<std::filesystem::path> plot_run(std::filesystem::path const& run,
                                            std::filesystem::path const& out,
                                            std::string const& field = "pressure");

/// Whether plot_run gives a picture this name.
bool is_picture_of_run(std::string const& file_name);

}  // namespace moraine
