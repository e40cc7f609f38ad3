// A run on a screen of text.
#pragma once

#include <cstddef>
#include <string>

#include "report/run_files.hpp"

namespace moraine::watch {

/// How much text there is room for.
struct ScreenSize {
  std::size_t columns = 80;
  std::size_t rows = 24;
};

/// What a run is doing: how far it is, what limits its time step, what its guards have seen, and a
/// line with a small plot for as many columns of readings and energies as there is room for. Lines
/// are no longer than the screen is wide.
std::string screen_of(report::RunFiles const& run, ScreenSize const& size);

}  // namespace moraine::watch
