// What the step asks of the loops over pairs of solids.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "terms/pair_backend.hpp"

namespace moraine {

/// Besides the rates that a sweep adds in the store.
struct StrengthOutcome {
  std::array<double, 3> wall_force{};  // force of all walls on the particles [N]
  double wall_power = 0.0;             // what moving walls do to the particles [W]
};

struct StrengthMatter {
  std::vector<double> reference_density;  // kg/m^3, by material id
  std::vector<std::uint8_t> solid;        // whether it has a strength, by material id
  double artificial_stress = 0.0;         // epsilon [-]; 0: none
  double smoothing_factor = 1.0;          // h by the spacing
};

/// Keeps records of its own beside those of the main sweep and goes through the same lists, for
/// solids and what touches them alone. Only runs with a solid have one.
class StrengthBackend {
 public:
  virtual ~StrengthBackend() = default;

  /// Copies what the terms read: predicted_stress of the store, and the rest predicted by `ahead`
  /// seconds as in PairBackend::gather_fluid. Wall particles have been filled; the rates of the
  /// store are still those of the last step, so this comes before the main sweep.
  virtual void gather(ParticleStore const& store, Search const& search, WallData const& walls,
                      double ahead) = 0;

  /// Adds to acceleration and energy_rate, and sets velocity_gradient of solids; after the main
  /// sweep.
  virtual StrengthOutcome sweep(ParticleStore& store, Search const& search) = 0;

  /// As those of OptionBackend.
  virtual void add_loads_on_walls(ParticleStore const& store, Search const& search,
                                  std::vector<WallLoad>& loads) const = 0;
  virtual void add_loads_on_mirrors(ParticleStore const& store, Search const& search,
                                    std::vector<MirrorLoad>& loads) const = 0;

  virtual std::size_t bytes() const = 0;
};

/// Flavour mixed or full.
std::unique_ptr<StrengthBackend> make_strength_backend(int dimension, Flavour flavour,
                                                       SweepParameters const& sweep,
                                                       StrengthMatter matter);

}  // namespace moraine
