// The stress of a particle.
#pragma once

#include "matter/strength/deviator.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Deviatoric stress [Pa]; zero of a fluid.
Deviator deviator_of(ParticleStore const& store, std::size_t i);

}  // namespace moraine
