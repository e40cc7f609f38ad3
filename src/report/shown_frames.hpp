// The frames and particles that a report shows, read from the files of a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "report/run_files.hpp"

namespace moraine::report {

/// A field of particles by name; a vector is its size and its components.
struct ShownField {
  std::string name, unit;
  bool category = false;
};

/// Some particles of one frame, by ascending id.
struct ShownFrame {
  double time = 0.0;  // s
  std::vector<std::uint32_t> ids;
  std::vector<std::vector<double>> places;  // [axis], m
  std::vector<std::vector<double>> values;  // [field]
};

/// What is shown of a run.
struct ShownFrames {
  int dimension = 3;
  std::size_t total = 0;             // particles of the first frame
  std::size_t frames_of = 0;         // frames that the run has
  std::vector<std::size_t> numbers;  // of the frames shown
  std::vector<ShownField> fields;
  std::vector<ShownFrame> frames;
};

/// How many frames and which share of the particles fit.
struct Selection {
  std::size_t frames = 0;
  double share = 1.0;
};

/// For `frames` frames of `particles` particles with `bytes_each` bytes: all, where `bytes` are
/// enough for them. Else frames are left out first, down to twenty, and then particles; never more
/// than `most_particles` of them.
Selection select(std::size_t frames, std::size_t particles, std::size_t bytes_each,
                 std::size_t bytes, std::size_t most_particles);

/// Whether a share of all particles holds the one with this id: the same answer in every frame,
/// and without any pattern.
bool is_in_share(std::uint64_t id, double share);

/// Reads the frames that fit into `bytes`. Throws std::runtime_error where one cannot be read.
ShownFrames read_shown_frames(RunFiles const& run, std::size_t bytes, std::size_t most_particles);

/// Places of walls of a file, [axis], thinned by share to at most `most`.
std::vector<std::vector<double>> read_wall_places(std::filesystem::path const& file, int dimension,
                                                  std::size_t most);

}  // namespace moraine::report
