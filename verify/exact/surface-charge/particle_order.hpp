// Whether particles lie as they must: as mirror images of each other, and with their own kind.
#pragma once

#include <cstdint>
#include <vector>

#include "step/simulation.hpp"

namespace moraine {

/// Number of the particle that begins at the mirror image of each.
std::vector<std::uint64_t> mirror_images(ParticleStore const& store);

/// Largest difference between a particle and the one that began as its mirror image [spacings]. Of
/// one that has left the domain it is known that it is beyond its sides: the other is off by its
/// own way out at least.
double asymmetry(Simulation const& simulation, std::vector<std::uint64_t> const& mirror);

/// Particles alone inside the other material: all their neighbours within 1.5 of their own size,
/// which grows as gas expands, belong to it, and lie around them. Gas at the wall of the crater has
/// sand on one side only.
int strangers(ParticleStore const& store);

}  // namespace moraine
