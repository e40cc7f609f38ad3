// One point of a material without neighbours: what its laws make of a deformation.
#pragma once

#include "matter/eos/eos.hpp"
#include "matter/strength/strength.hpp"

namespace moraine {

struct ElementState {
  double density = 0.0;          // kg/m^3
  double specific_energy = 0.0;  // J/kg
  double pressure = 0.0;         // Pa
  double distension = 1.0;       // that compaction has left [-]
  StressState shear{};           // deviatoric stress, plastic strain and work
  Symmetric<3> strain{};         // logarithmic, summed up; tension positive [-]

  /// sigma = s - p 1 [Pa].
  Symmetric<3> stress() const;
};

/// Equation of state and strength as a run has them, adiabatic:
///
///   rho' = rho exp(-tr d eps),   e' = e + (sigma + sigma')/2 : d eps / rho_mean
///
/// The pressure is that of the end of the deformation; the stress yields at it.
class MaterialElement {
 public:
  MaterialElement(Eos eos, Strength strength) : eos_(eos), strength_(strength) {}

  /// The undisturbed material at `pressure` [Pa], energy of the reference state, no shear.
  /// Throws std::domain_error where the law has no such state.
  ElementState at_pressure(double pressure) const;

  ElementState after(ElementState const& before, Deformation const& d) const;

 private:
  /// Pressure of a state, which notes how far it has been compacted since `before`.
  void find_pressure(ElementState& state, ElementState const& before) const;
  StressState shear_after(StressState const& before, Deformation const& d, double pressure) const;

  Eos eos_;
  Strength strength_;
};

}  // namespace moraine
