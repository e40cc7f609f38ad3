// Where the energy of a run goes, integrated in time.
#pragma once

#include "base/archive.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// Work and heat since the start [J]; in 2D per metre of thickness, in 1D per square metre.
///
/// Every rate P is integrated as the step integrates the energy equation, dt/2 (P^n + P^n+1). While
/// nothing leaves the domain the change of internal energy is therefore, to rounding,
///   compression + viscosity + wall_viscosity + detonation,
/// in each step and for any step length. The total of kinetic, internal, potential and lost energy
/// less what moving walls, damping and detonation gave, is conserved to second order in the time
/// step only; `error` is what is missing. `diffusion` is no part of the balance:
/// density diffusion changes densities, hence the elastic energy that the equation of state would
/// give back, and the energy equation does not know it; see docs/probes.md.
///
/// Costs another loop over all pairs in each step, nearly as long as the sweep.
class EnergyBudget {
 public:
  /// Call at the start and after each step.
  void tell(Simulation const& simulation);

  /// Call when a stage has begun and the rates of its first state are there: the next step goes on
  /// with those.
  void tell_new_rates(Simulation const& simulation);

  double viscosity() const { return done_.viscosity; }
  double wall_viscosity() const { return done_.wall_viscosity; }
  double compression() const { return done_.compression; }
  double diffusion() const { return done_.diffusion; }
  /// Kinetic + internal + potential + lost energy now, less that at the start and what
  /// walls and stages have given since (Simulation::booked).
  double error(Simulation const& simulation) const;

  void exchange(Archive& archive);

 private:
  struct Amounts {
    double viscosity = 0.0, wall_viscosity = 0.0, compression = 0.0, diffusion = 0.0;
  };
  static Amounts rates(Simulation const& simulation);  // W

  std::uint64_t told_ = 0;  // calls
  double start_ = 0.0;      // J
  Amounts last_, done_;
};

}  // namespace moraine
