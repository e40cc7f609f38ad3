#include "verify/particle_value.hpp"

namespace moraine {

double pressure_of(ParticleStore const& store, std::size_t particle) {
  return store.scalar(Field::pressure)[particle];
}

double density_of(ParticleStore const& store, std::size_t particle) {
  return store.scalar(Field::density)[particle];
}

double velocity_of(ParticleStore const& store, std::size_t particle) {
  return store.component(Field::velocity, 0)[particle];
}

double axial_stress(ParticleStore const& store, std::size_t particle) {
  return pressure_of(store, particle) - store.component(Field::deviatoric_stress, 0)[particle];
}

double plastic_work_of(ParticleStore const& store, std::size_t particle) {
  return store.scalar(Field::plastic_work)[particle];
}

}  // namespace moraine
