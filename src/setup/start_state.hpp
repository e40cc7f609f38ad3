// The end state of another run, from which a case may start.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// What happens to the velocities that particles had at the end of the other run.
enum class StartVelocities : std::uint8_t { keep, zero };

/// A material of the other run: its name, and its constants as lines of a case file.
struct StartMaterial {
  std::string name;
  std::string constants;
};

/// What is known of the other run beside its particles.
struct StartInfo {
  std::string run;         // its folder, seen from that of the case file
  std::string checkpoint;  // name of the file in it
  std::string sha256;      // of that file
  double time = 0.0;       // s, of the state
  double end = 0.0;        // s, of that run
  std::uint64_t step = 0;
  int dimension = 0;
  double spacing = 0.0;                  // m
  double finest_spacing = 0.0;           // m
  std::vector<StartMaterial> materials;  // by the ids of its particles
};

/// Where a case starts from, and what was found there.
struct StartSpec {
  std::string run;  // folder; after reading a case file: absolute; empty: from no other run
  StartVelocities velocities = StartVelocities::keep;
  StartInfo info;
  /// Fluid particles in the order of their ids; null until the state has been read
  /// (output/checkpoint/start_reader.hpp), and when it is not needed any more.
  std::shared_ptr<ParticleStore const> particles;
};

/// Saves or restores a state that a case starts from.
void exchange_start(Archive& archive, StartInfo& info, ParticleStore& particles);

}  // namespace moraine
