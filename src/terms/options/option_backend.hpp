// What the step asks of the loops of the optional terms.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "terms/options/option_parameters.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

/// What a sweep of the optional terms tells besides the rates that it adds in the store.
struct OptionOutcome {
  double viscous_rate = 0.0;         // largest nu / h^2 [1/s]
  std::size_t viscous_particle = 0;  // whose, index in the store
  double penalty_rate = 0.0;         // largest k / m of the penalties [1/s^2]
  std::size_t penalty_particle = 0;
  std::array<double, 3> wall_force{};  // force of all walls on the fluid [N]
  double wall_power = 0.0;             // what moving walls do to the fluid [W]
  double penalty_energy = 0.0;         // potential of the penalties [J]
  EnergyRates energy;                  // by viscosity and diffusion

  void add(OptionOutcome const& other);
};

/// Keeps records of its own beside those of the main sweep and goes through the same lists. Only
/// runs that ask for an option have one.
class OptionBackend {
 public:
  virtual ~OptionBackend() = default;

  /// Sets the density of the fluid to its sum over neighbours, normalised or not. Velocities and
  /// energies do not matter.
  virtual void sum_densities(ParticleStore& store, Search const& search, WallData const& walls,
                             bool normalised) = 0;

  /// Copies what the terms read: the state predicted by `ahead` seconds, as in
  /// PairBackend::gather_fluid. Wall particles have been filled; the rates of the store are still
  /// those of the last step, so this comes before the main sweep.
  virtual void gather(ParticleStore const& store, Search const& search, WallData const& walls,
                      double ahead) = 0;

  /// Adds all optional terms to acceleration, density_rate and energy_rate, and sets drift where
  /// the particles have it; after the main sweep.
  virtual OptionOutcome sweep(ParticleStore& store, Search const& search) = 0;

  /// Adds what the last sweep put on the fluid to the loads of PairBackend::loads_on_walls, and of
  /// loads_on_mirrors.
  virtual void add_loads_on_walls(ParticleStore const& store, Search const& search,
                                  std::vector<WallLoad>& loads) const = 0;
  virtual void add_loads_on_mirrors(ParticleStore const& store, Search const& search,
                                    std::vector<MirrorLoad>& loads) const = 0;

  virtual std::size_t bytes() const = 0;
};

/// By material id.
struct OptionMatter {
  std::vector<double> reference_density;  // kg/m^3
  std::vector<double> dynamic_viscosity;  // Pa s
  std::vector<int> penalty_group;         // any number for each group
};

/// Flavour mixed or full.
std::unique_ptr<OptionBackend> make_option_backend(int dimension, Flavour flavour,
                                                   SweepParameters const& sweep,
                                                   OptionParameters const& options,
                                                   OptionMatter matter);

}  // namespace moraine
