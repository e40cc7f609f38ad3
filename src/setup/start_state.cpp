#include "setup/start_state.hpp"

#include <fmt/core.h>

namespace moraine {

void exchange_start(Archive& archive, StartInfo& info, ParticleStore& particles) {
  archive.text("start/run", info.run);
  archive.text("start/checkpoint", info.checkpoint);
  archive.text("start/sha256", info.sha256);
  archive.number("start/time", info.time);
  archive.number("start/end", info.end);
  archive.number("start/step", info.step);
  auto dimension = static_cast<std::uint64_t>(info.dimension);
  archive.number("start/dimension", dimension);
  info.dimension = static_cast<int>(dimension);
  archive.number("start/spacing", info.spacing);
  archive.number("start/finest_spacing", info.finest_spacing);
  std::uint64_t count = info.materials.size();
  archive.number("start/material_count", count);
  info.materials.resize(count);
  for (std::size_t m = 0; m < count; ++m) {
    archive.text(fmt::format("start/material_{}/name", m), info.materials[m].name);
    archive.text(fmt::format("start/material_{}/constants", m), info.materials[m].constants);
  }
  if (archive.restoring()) particles = ParticleStore(info.dimension);
  particles.exchange(archive);
}

}  // namespace moraine
