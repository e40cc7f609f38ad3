// Energy that comes into a run, or leaves it, by what a case does to it.
#pragma once

#include "base/archive.hpp"
#include "store/particle_store.hpp"

namespace moraine {

struct ConservedSums;
struct LostParticles;

/// Energy given to the particles since the start [J]; in 2D per metre of thickness, in 1D per
/// square metre. Removing a wall takes and gives nothing: walls hold no energy.
struct BookedEnergy {
  double damping = 0.0;     // work of the damping of stages and absorbing layers; never positive
  double detonation = 0.0;  // what transformations have changed the internal energy by
  double walls = 0.0;       // work of moving walls, integrated as the step integrates energies

  double drift = 0.0;  // work of gravity on places that move beside the material

  double total() const { return damping + detonation + walls + drift; }
  void exchange(Archive& archive);
};

/// Power of damping [W]: - damping sum m v . v_h. The step damps with the velocity v_h = v - half a
/// that is half a step old; `half` [s] is that half step, 0 for rates made anew. Integrated with
/// half a step at both of its ends, as everything else, it closes the total to second order.
double power_of_damping(ParticleStore const& store, double damping, double half);

/// What particles that move beside their material add to the potential energy [W]: - sum m g .
/// drift.
double power_of_drift(ParticleStore const& store, std::array<double, 3> const& gravity);

/// Kinetic, internal and potential energy of all particles, with what lost ones took along and
/// without what was booked [J]: constant to second order in the time step.
double energy_balance(ConservedSums const& sums, LostParticles const& lost,
                      BookedEnergy const& booked);

}  // namespace moraine
