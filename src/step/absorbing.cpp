// What absorbing layers take away in a step.
#include <array>
#include <cmath>

#include "base/parallel_for.hpp"
#include "step/simulation.hpp"
#include "store/place.hpp"

namespace moraine {

namespace {

/// Speed of waves in the reference state of each material [m/s]; in place, without memory.
std::array<double, no_material> rest_speeds(std::vector<Material> const& materials) {
  std::array<double, no_material> speeds;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    Material const& material = materials[m];
    double const rho = reference_density(material.eos);
    double const c = std::visit(
        [&](auto const& law) { return law.sound_speed(rho, law.reference_energy); }, material.eos);
    speeds[m] = std::sqrt(c * c + 4.0 / 3.0 * shear_modulus(material.strength) / rho);
  }
  return speeds;
}

}  // namespace

/// Lets velocity, compression and stress fade over the step that has just been made, by
/// exp(-a dt): after the other rates, so that no step is too long for it. Internal energy stays;
/// what kinetic energy is taken is booked as damping. Only what began in a layer fades: products
/// and ejecta that come into its space later fly on.
void Simulation::absorb() {
  AbsorbingLayers const& layers = model_.absorbing;
  if (!layers.any() || half_step_factor_ == 0.0) return;
  ParticleStore& store = model_.particles;
  auto const speeds = rest_speeds(model_.materials);
  auto const rest = store.scalar(Field::rest_density);
  auto density = store.scalar(Field::density);
  auto const mass = store.scalar(Field::mass);
  bool const solid = store.has(Field::deviatoric_stress);
  double const dt = vote_.time_step;
  auto const fade = [&](std::size_t begin, std::size_t end) {
    double taken = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      if (rest[i] == 0.0) continue;  // began elsewhere, or is a gas that only came by
      double const fading = layers.fading(place_of(store, i));
      if (fading == 0.0) continue;
      double const left = std::exp(-fading * speeds[store.material()[i]] * dt);
      for (int axis = 0; axis < model_.dimension; ++axis) {
        double& v = store.component(Field::velocity, axis)[i];
        taken += 0.5 * mass[i] * v * v * (1.0 - left * left);
        v *= left;
      }
      if (density_is_state()) density[i] = rest[i] + (density[i] - rest[i]) * left;
      if (solid)
        for (int k = 0; k < components(Rank::symmetric, model_.dimension); ++k)
          store.component(Field::deviatoric_stress, k)[i] *= left;
    }
    return taken;
  };
  booked_.damping -= reduce_blocks(store.range(Kind::fluid).size(), 0.0, fade,
                                   [](double a, double b) { return a + b; });
}

}  // namespace moraine
