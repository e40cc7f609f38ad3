// Numbers of one particle, for what finds places and means of them.
#pragma once

#include <cstddef>

#include "store/particle_store.hpp"

namespace moraine {

/// A number of one particle.
using ParticleValue = double (*)(ParticleStore const& store, std::size_t particle);

double pressure_of(ParticleStore const& store, std::size_t particle);  // Pa
double density_of(ParticleStore const& store, std::size_t particle);   // kg/m^3
double velocity_of(ParticleStore const& store, std::size_t particle);  // m/s, along x
/// Of the stress along x, positive in compression: -sigma_xx = p - s_xx [Pa].
double axial_stress(ParticleStore const& store, std::size_t particle);
double plastic_work_of(ParticleStore const& store, std::size_t particle);  // J/kg

}  // namespace moraine
