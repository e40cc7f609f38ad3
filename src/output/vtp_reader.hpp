// Reads back the particle frames of this program.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// One array of a frame, converted to double: component c of particle i is
/// values[i * components + c].
struct FrameArray {
  std::string name;
  std::string unit;  // empty where there is none
  std::size_t components = 1;
  std::vector<double> values;
};

/// The particles of one `.vtp` file.
struct ParticleFrame {
  double time = 0.0;  // s
  int dimension = 3;
  std::size_t size = 0;  // particles
  FrameArray points;     // m
  std::vector<FrameArray> arrays;

  /// The array with this name, or nullptr.
  FrameArray const* find(std::string_view name) const;
};

/// Reads the dialect that `write_vtp` writes: PolyData in one piece, raw appended, little endian,
/// UInt64 headers, no compression. Other `.vtp` files are refused with a std::runtime_error that
/// says what is not understood, as are missing and cut-off files. Integers above 2^53 (ids) lose
/// their last digits.
ParticleFrame read_vtp(std::filesystem::path const& path);

}  // namespace moraine
