// A picture of a case before it runs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vec3.hpp"

namespace moraine {

/// Particles that share a colour and a line of the legend.
struct PreviewPart {
  std::string name;
  std::vector<Vec3> positions;  // m
  double spacing = 0.0;         // m; 0: that of the picture
};

/// What a picture of a case shows.
struct Preview {
  int dimension = 2;
  double spacing = 0.0;              // m
  std::vector<PreviewPart> regions;  // or their layers
  std::vector<Vec3> walls;           // m, drawn grey
  std::vector<PreviewPart> probes;   // drawn as crosses
  Vec3 at{};                         // m, 3D: the place where the three slices meet
};

/// Draws the particles of each part in its colour, walls in grey, probes as crosses with their
/// names, and a legend with the number of particles. In 3D three slices, of each part as thick as
/// its spacing, through the place `at`: across z, across y and across x; probes show in all of
/// them. SVG or PNG by file ending. Throws std::runtime_error if the file cannot be written.
void plot_preview(Preview const& preview, std::filesystem::path const& out);

}  // namespace moraine
