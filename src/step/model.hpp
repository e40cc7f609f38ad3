// What a simulation starts from: particles, materials, walls and settings, ready to run.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "matter/burn/burn.hpp"
#include "matter/eos/eos.hpp"
#include "matter/strength/strength.hpp"
#include "search/side_images.hpp"
#include "step/absorbing_layer.hpp"
#include "step/guard.hpp"
#include "step/settings.hpp"
#include "step/stages.hpp"
#include "store/particle_store.hpp"
#include "surface/symmetry.hpp"
#include "terms/options/option_backend.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

struct Material {
  std::string name;
  Eos eos;
  /// Programmed burn, of an equation of state with pressure_by_energy; none: it is burnt from the
  /// start. The particles of a model with burning materials use burn_fraction, and lighting_time,
  /// which is infinite for those that are to be lit when their time comes.
  std::optional<Burn> burn{};
  double dynamic_viscosity = 0.0;  // Pa s
  /// The particles of a model with a solid use the fields of solid_fields.
  Strength strength{};
  /// Once at the least pressure of its equation of state it parts: from then on it bears neither
  /// tension nor, in tension, shear. Particles of a model with such a material use spalled.
  bool spalls = false;
  std::string penalty_group{};  // the penalty keeps materials of different groups apart
};

/// Optional fields that particles have where any material has a strength.
inline constexpr std::array solid_fields{Field::deviatoric_stress, Field::predicted_stress,
                                         Field::velocity_gradient, Field::plastic_strain,
                                         Field::plastic_work};

struct Model {
  int dimension = 3;
  std::array<double, 3> domain_min{};  // m
  std::array<double, 3> domain_max{};  // m
  std::array<bool, 3> periodic{};
  Symmetry symmetry;
  /// Sides of the domain that are faces of mirror walls; `open` elsewhere.
  std::array<std::array<Plane, 2>, 3> mirror_walls{};
  std::array<double, 3> gravity{};  // m/s^2
  AbsorbingLayers absorbing;        // with any, the particles use rest_density
  Numerics numerics;
  /// m, the smallest spacing that fluid particles started with; 0: that of `numerics`.
  double finest_spacing = 0.0;
  TimeSpec time;
  GuardSettings guards;
  std::vector<Material> materials;  // by MaterialId
  ParticleStore particles{3};
  WallData walls;
  std::vector<Stage> stages;  // in their order; none: one stage without a name
  /// What reflects at a side of the domain.
  Plane plane(std::size_t axis, std::size_t end) const {
    return symmetry.planes[axis][end] ? Plane::symmetry : mirror_walls[axis][end];
  }
  bool has_solids() const {
    return std::any_of(materials.begin(), materials.end(),
                       [](Material const& m) { return is_solid(m.strength); });
  }
  Flavour flavour() const {
    return numerics.precision == Precision::mixed ? Flavour::mixed : Flavour::full;
  }
};

}  // namespace moraine
