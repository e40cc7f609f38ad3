// Formulas of the fields of a particle.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "motion/formula.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Fields that formulas know, by the names of the arrays of frames: x, y, z [m], velocity_x ...,
/// speed, density, pressure, specific_energy, sound_speed, mass, volume (mass by density),
/// smoothing_length, burn_fraction, distension, stress_xx ... stress_yz (tension positive, pressure
/// included), shear_stress (sqrt(J2)), plastic_strain, plastic_work, and the time of the reading.
std::vector<std::string> const& particle_variables();

/// A name in a formula that means nothing, and where it stands, counted from 1.
struct UnknownName {
  std::string name;
  std::size_t position;
};
std::optional<UnknownName> unknown_name(std::string const& formula);

/// All that a formula may name: fields, functions, constants.
std::vector<std::string_view> const& known_names();

/// Why a text is no formula of a particle, with the position; empty where it is one.
std::string formula_fault(std::string const& formula);

/// A formula evaluated for one particle after the other. What a particle does not have is zero
/// (burn_fraction, components beyond the dimension), one (distension) or that of all
/// (smoothing_length [m]).
class ParticleFormula {
 public:
  explicit ParticleFormula(std::string const& text) : formula_(text, particle_variables()) {}

  double operator()(ParticleStore const& store, std::size_t i, double smoothing_length,
                    double time) const;

 private:
  Formula formula_;
};

}  // namespace moraine
