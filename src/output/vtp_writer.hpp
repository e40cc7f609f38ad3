// Particle frames for ParaView.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "store/particle_store.hpp"

namespace moraine {

/// Values that belong to particles and are not in the store.
struct ParticleArray {
  std::string name;
  std::string unit;
  std::span<double const> by_id;  // of at least as many ids as the fluid has
};

/// Writes the particles of one kind as VTK XML PolyData: raw appended data, little endian, UInt64
/// block headers, one vertex cell per particle.
///
/// Point data: velocity, density, pressure, specific_energy, sound_speed, mass (Float32, SI units),
/// material, kind (UInt8), id (UInt64), and the arrays in `more` (Float32). Each array carries its
/// unit as the information key vtkDataArray::UNITS_LABEL, so names stay plain. FieldData: TimeValue
/// [s] and dimension. Vectors and points always have three components, zero beyond the dimension of
/// the store.
///
/// Float32, because a frame is for looking: it resolves 1e-7 of the domain and of each value, which
/// is far below what a picture shows, and halves the files; the full state is a checkpoint's task.
/// One kind per file, because colour ranges of the fluid then do not feel the walls, walls can be
/// shown and hidden on their own, and fixed walls are written once.
///
/// `time` in s. The file appears complete or not at all; throws std::runtime_error if it cannot be
/// written.
void write_vtp(std::filesystem::path const& path, ParticleStore const& store, Kind kind,
               double time, std::vector<ParticleArray> const& more = {});

}  // namespace moraine
