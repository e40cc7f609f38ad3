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

using Places = std::vector<std::vector<double>>;  // [axis], m

/// What may be shown of a run: numbers of bytes before compression.
struct ParticleBudget {
  std::size_t bytes = 11'000'000;
  std::size_t most_particles = 50'000;  // in a frame: what a browser draws and picks with ease
};

/// Some particles of one frame, by ascending id.
struct ShownFrame {
  double time = 0.0;  // s
  std::vector<std::uint32_t> ids;
  Places places;
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
  std::vector<Places> walls;  // of each frame shown, or one for all where walls rest; or none
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

/// Reads what fits of the frames: where not everything does, frames are left out first, evenly,
/// down to some twenty, and then particles, those whose ids hash into a share, the same ones in all
/// frames. Particles without an id are left out. Throws std::runtime_error where a frame cannot be
/// read.
ShownFrames read_shown_frames(RunFiles const& run, ParticleBudget const& budget);

/// The part of it that fits into less.
ShownFrames thinned(ShownFrames shown, ParticleBudget const& budget);

}  // namespace moraine::report
