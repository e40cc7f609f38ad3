// A case as plain data: what the case file says, checked and in SI units.
//
// Nothing here knows about TOML or about particles. `setup/read_case` makes a Case from a file,
// `setup/build_model` makes particles and walls from a Case. Points and vectors always have three
// components; those beyond `dimension` are zero.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "matter/eos/eos.hpp"
#include "motion/formula.hpp"
#include "setup/burn_spec.hpp"
#include "setup/motion_spec.hpp"
#include "setup/probe_spec.hpp"
#include "setup/reference_spec.hpp"
#include "setup/shape/shape.hpp"
#include "setup/stage_spec.hpp"
#include "setup/start_state.hpp"
#include "setup/strength_spec.hpp"
#include "step/guard.hpp"
#include "step/settings.hpp"
#include "surface/symmetry.hpp"

namespace moraine {

/// Rigid rotation about an axis through a point: v = rate unit(axis) x (x - center).
struct Rotation {
  std::optional<double> rate;  // rad/s
  Point center{};
  Point axis{0.0, 0.0, 1.0};  // of any length but zero; always z in 2D
};

/// Velocities as formulas of the place, one for each axis; none: zero.
struct VelocityField {
  std::vector<std::string> texts;  // of x, y, z [m], in m/s
  std::vector<Formula> formulas;   // what these say; set where the case is checked
};

/// What the particles of a region start with. At most one of pressure, hydrostatic_level,
/// lithostatic_load is given; absent values follow from the material: reference density, reference
/// specific energy.
struct InitialState {
  Point velocity{};                         // m/s
  std::optional<double> density;            // kg/m^3
  std::optional<double> specific_energy;    // J/kg
  std::optional<double> pressure;           // Pa; density or energy is solved for it
  std::optional<double> hydrostatic_level;  // m, height of the free surface against gravity
  Rotation rotation{};                      // added to the velocity
  VelocityField velocity_field{};           // added to the velocity
  std::optional<double> lithostatic_load;   // Pa, on top of the weight of all that lies above
};

/// What becomes of a material at its least pressure: it stays there, or parts.
enum class TensionEnd : std::uint8_t { floor, spall };

/// A named material: its equation of state and reference state, how it burns, and its strength.
struct MaterialSpec {
  std::string name;
  Eos eos;
  BurnSpec burn{};
  double dynamic_viscosity = 0.0;  // Pa s
  StrengthSpec strength{};
  TensionEnd tension = TensionEnd::floor;
  std::string penalty_group{};  // empty: solids are bonded, any other material is of its own

  /// The penalty keeps materials of different groups apart.
  std::string group() const {
    if (!penalty_group.empty()) return penalty_group;
    return strength.kind == StrengthKind::none ? name : "solids";
  }
};

/// Layers of several materials from the top downwards, against gravity. There are as many
/// thicknesses as materials, or one less: the last layer then has no lower end.
struct Layers {
  std::vector<std::string> materials;  // empty: no layers
  std::vector<double> thickness;       // m
  std::optional<double> top;           // m, height of the uppermost face; default: of the shape
};

/// Where the particles start; see setup/lattice.hpp.
enum class LatticeName : std::uint8_t { square, hexagonal };

/// Particles of one material, or of layers, on the lattice points of a shape, with others added to
/// it and taken away from it (ShapeTree). A later region replaces an earlier one where they
/// overlap.
struct RegionSpec {
  std::string name;
  std::string material;  // empty with layers
  Shape shape;
  InitialState initial;
  std::vector<ShapeTree> plus{};
  std::vector<ShapeTree> minus{};
  Layers layers{};
  // At most one of the two; none: the lattice of the case (setup/region_lattice.hpp).
  std::optional<double> spacing{};  // m, of its own lattice
  std::string equal_mass_with{};    // the region whose particles have the mass of these
};

enum class WallForm : std::uint8_t { container, solid };  // fluid inside the box | outside of it
enum class Slip : std::uint8_t { free, none };
enum class WallMethod : std::uint8_t { dummy, mirror, repulsive, mirror_and_repulsive };

/// A rigid wall: the faces of a box. `open` lists sides without a wall ("z+" = the top). The box is
/// where the wall is before any motion.
struct WallSpec {
  std::string name;
  WallForm form = WallForm::container;
  Box box;
  std::array<std::array<bool, 2>, 3> open{};  // [axis][0: minus side, 1: plus side]
  Slip slip = Slip::free;
  WallMethod method = WallMethod::dummy;
  std::optional<double> repulsion{};        // D [m^2/s^2], of methods that push
  std::optional<double> repulsion_range{};  // r_0 [m]; none: half a spacing
  MotionSpec motion{};
  bool mirrors() const {
    return method == WallMethod::mirror || method == WallMethod::mirror_and_repulsive;
  }
  bool pushes() const {
    return method == WallMethod::repulsive || method == WallMethod::mirror_and_repulsive;
  }
};

enum class GaugeKind : std::uint8_t {
  point,
  front,
  wall,
  line,
  level,
  sums,
  side,
  budget,
  crater,
  deposit,
  bubble,
  rise,
  expression,
  plane,
  particle
};
inline constexpr std::size_t gauge_kind_count = 15;

/// `point`: Shepard-interpolated pressure, density, velocity and energy at a fixed place.
/// `particle`: the same and the place of the particle that was nearest there at the start.
/// `front`: the farthest particle position of a material along an axis.
/// The other kinds are in setup/probe_spec.hpp.
struct GaugeSpec {
  std::string name;
  GaugeKind kind = GaugeKind::point;
  Point position{};      // point, particle
  std::string material;  // front
  int axis = 0;          // front
  int direction = +1;    // front: +1 the largest coordinate, -1 the smallest
  ProbeSpec probe;       // the other kinds
};

struct OutputSpec {
  double frame_interval = 0.0;         // s; 0: only the first and the last frame
  std::vector<double> frame_times;     // s; extra frames
  double gauge_interval = 0.0;         // s; 0: every step
  double sums_interval = 0.0;          // s; 0: every step
  double checkpoint_interval = 600.0;  // s of wall time; 0: none while the run goes on
  // Pa: a rise of the pressure that counts as arrival; frames hold envelopes where it is given.
  std::optional<double> arrival_pressure;
};

/// Where the value of a key stands in the case file, and how it is written.
struct Place {
  std::size_t line = 0;
  std::size_t column = 0;
  std::string text;
};

/// Sides at whose ends waves are absorbed instead of reflected; step/absorbing_layer.hpp.
struct AbsorbingSpec {
  std::array<std::array<bool, 2>, 3> sides{};  // [axis][0: minus, 1: plus]
  double thickness = 0.0;                      // m
  double reflection = 1e-3;
};

struct Case {
  std::string title;
  std::string file;  // as given by the user
  int dimension = 2;
  Box domain{};  // particles that leave it are counted and removed
  std::array<bool, 3> periodic{};
  Symmetry symmetry{};
  Point gravity{};  // m/s^2
  AbsorbingSpec absorbing{};
  LatticeName lattice = LatticeName::square;
  Numerics numerics;
  StartSpec start;
  TimeSpec time;
  OutputSpec output;
  GuardSettings guards;
  std::vector<MaterialSpec> materials;
  std::vector<RegionSpec> regions;
  std::vector<WallSpec> walls;
  std::vector<GaugeSpec> gauges;
  std::vector<StageSpec> stages;
  std::vector<ReferenceSpec> references;
  /// By full key ("resolution.spacing", "region.charge.pressure"), for messages; empty for a case
  /// that comes from no file.
  std::map<std::string, Place> places;
};

/// A mistake of a case as a whole, at the place of its key, or of what that is part of.
InputProblem problem_of(Case const& c, std::string const& key, std::string rule,
                        std::string hint = {});

}  // namespace moraine
