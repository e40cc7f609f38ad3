#include "matter/point/material_element.hpp"

#include <cmath>
#include <stdexcept>

namespace moraine {

Symmetric<3> ElementState::stress() const {
  Symmetric<3> sigma = shear.stress;
  for (std::size_t k = 0; k < 3; ++k) sigma[k] -= pressure;
  return sigma;
}

ElementState MaterialElement::at_pressure(double pressure) const {
  ElementState state;
  state.specific_energy = reference_energy(eos_);
  state.density = std::visit(
      [&](auto const& law) { return law.density_at_pressure(pressure, state.specific_energy); },
      eos_);
  if (!(state.density > 0.0))
    throw std::domain_error("the equation of state has no such pressure at its reference energy");
  state.pressure = pressure;
  state.distension = virgin_distension(eos_);
  return state;
}

StressState MaterialElement::shear_after(StressState const& before, Deformation const& d,
                                         double pressure) const {
  return std::visit(
      [&](auto const& law) {
        if constexpr (requires { law.shear_modulus; })
          return advance_stress(law, before, d, pressure);
        else
          return before;
      },
      strength_);
}

void MaterialElement::find_pressure(ElementState& state, ElementState const& before) const {
  std::visit(
      [&](auto const& law) {
        if constexpr (is_compactable<std::decay_t<decltype(law)>>) {
          auto const response =
              law.respond(state.density, state.specific_energy, before.distension);
          state.pressure = response.pressure;
          state.distension = response.distension;
        } else {
          state.pressure = law.pressure(state.density, state.specific_energy);
        }
      },
      eos_);
}

ElementState MaterialElement::after(ElementState const& before, Deformation const& d) const {
  ElementState next = before;
  for (std::size_t k = 0; k < 6; ++k) next.strain[k] += d.strain[k];
  double const volume = d.strain[0] + d.strain[1] + d.strain[2];
  next.density = before.density * std::exp(-volume);
  double const mean_density = before.density * std::exp(-0.5 * volume);
  Symmetric<3> const start = before.stress();
  next.specific_energy = before.specific_energy + contraction(start, d.strain) / mean_density;
  constexpr int corrections = 2;  // of the energy by the stress at the end
  for (int k = 0; k < corrections; ++k) {
    find_pressure(next, before);
    next.shear = shear_after(before.shear, d, next.pressure);
    Symmetric<3> mean = next.stress();
    for (std::size_t n = 0; n < 6; ++n) mean[n] = 0.5 * (mean[n] + start[n]);
    next.specific_energy = before.specific_energy + contraction(mean, d.strain) / mean_density;
  }
  find_pressure(next, before);
  next.shear = shear_after(before.shear, d, next.pressure);
  return next;
}

}  // namespace moraine
