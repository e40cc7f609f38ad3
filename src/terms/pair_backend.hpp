// What the step asks of the pair loops, whatever dimension, precision, kernel and set of terms.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "search/search.hpp"
#include "smoothing/kernel_names.hpp"
#include "store/particle_store.hpp"
#include "terms/sweep_parameters.hpp"
#include "walls/wall_data.hpp"

namespace moraine {

/// Pair geometry and sums in single precision over fixed-point positions, or all in double, or the
/// plain scalar loop in double that the others are tested against.
enum class Flavour : std::uint8_t { mixed, full, reference };

/// Which pair terms and records (terms/schemes.hpp).
enum class SchemeName : std::uint8_t { liquid, compressible, variable };

/// What one sweep tells besides the rates it leaves in the store.
struct SweepOutcome {
  /// Largest c + s (alpha c + beta max|mu|) [m/s], s the viscous_signal of the parameters, each by
  /// its own h over that of the case.
  double signal_speed = 0.0;
  std::size_t particle = 0;            // whose, index in the store
  std::array<double, 3> wall_force{};  // force of all walls on the fluid [N]
  double wall_power = 0.0;             // what moving walls do to the fluid [W]

  /// Takes over a larger signal speed; the first that is not a number stays.
  void include(double signal, std::size_t whose) {
    if (std::isnan(signal_speed) || signal <= signal_speed) return;
    signal_speed = signal;
    particle = whose;
  }
};

/// What the fluid does to one wall particle.
struct WallLoad {
  std::array<double, 3> force{};  // N
  bool wet = false;               // fluid is closer than the support
};

/// What one particle of the fluid does to mirror walls.
struct MirrorLoad {
  std::uint32_t particle = 0;                    // index in the store
  std::array<std::array<double, 3>, 6> force{};  // N, by side of the domain: 2 axis + (0 | 1 plus)
};

/// Where energy goes at one instant, summed over all particles [W].
struct EnergyRates {
  double viscosity = 0.0;       // heat of the artificial viscosity between fluid particles
  double wall_viscosity = 0.0;  // the same between fluid and walls
  double diffusion = 0.0;  // sum of m p / rho^2 d(rho)/dt by density diffusion: elastic energy that
                           // the term adds behind the back of the energy equation
};

/// Keeps the gathered records and runs the loops over pairs.
class PairBackend {
 public:
  virtual ~PairBackend() = default;

  /// Copies fluid particles to records: velocity and density predicted by `ahead` seconds of their
  /// rates; pressure and sound speed as they stand in the store. Images follow.
  virtual void gather_fluid(ParticleStore const& store, Search const& search, double ahead) = 0;

  /// Extrapolates pressure, density and sound speed to the wall particles and makes their records.
  virtual void gather_walls(ParticleStore& store, Search const& search, WallData const& walls) = 0;

  /// Sums all terms over all pairs; writes acceleration (without gravity), density_rate and
  /// energy_rate of the fluid.
  virtual SweepOutcome sweep(ParticleStore& store, Search const& search) = 0;

  /// The forces that the last sweep put on the fluid, seen from the walls: one load for each of
  /// search.wet_walls(), in their order. A pass over the lists of wall particles in scalar double,
  /// for the moments at which somebody asks; the sum of all loads is the opposite of wall_force.
  virtual void loads_on_walls(ParticleStore const& store, Search const& search,
                              std::vector<WallLoad>& loads) const = 0;

  /// The forces that the last sweep put on the fluid through its images at walls, seen from the
  /// walls: one load for each particle that has such images near. An image beyond several walls
  /// loads the one that the line to it meets first. Else as loads_on_walls.
  virtual void loads_on_mirrors(ParticleStore const& store, Search const& search,
                                std::vector<MirrorLoad>& loads) const = 0;

  /// Rates at the state of the last sweep. A pass over all pairs with the dissipative terms alone.
  virtual EnergyRates energy_rates(ParticleStore const& store, Search const& search) const = 0;

  /// Directed pairs of a fluid particle with a fluid or wall neighbour closer than the support.
  virtual std::uint64_t count_pairs(Search const& search) const = 0;

  virtual std::size_t bytes() const = 0;
};

/// A backend; reference densities by material id [kg/m^3].
std::unique_ptr<PairBackend> make_pair_backend(int dimension, Flavour flavour, SchemeName scheme,
                                               SweepParameters const& parameters,
                                               std::vector<double> reference_densities);

}  // namespace moraine
