// The state of a run that broke down, apart from its good frames.
#pragma once

#include <filesystem>
#include <vector>

#include "step/simulation.hpp"
#include "step/simulation_error.hpp"

namespace moraine {

/// Writes all particles as they were to bad/frame.vtp, whose path it returns, and those of walls,
/// if there are any, to bad/walls.vtp. The array `guard` of the frame flags the culprits: 0 for the
/// others, else flag_of(the guard that names them). Throws OutputError.
std::filesystem::path write_bad_frame(std::filesystem::path const& folder,
                                      Simulation const& simulation, std::vector<Flag> const& flags);

/// Removes what write_bad_frame has written.
void drop_bad_frame(std::filesystem::path const& folder);

}  // namespace moraine
