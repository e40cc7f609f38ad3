// The neighbour search of a run: orders the store by cells, makes the lists and keeps them valid.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/archive.hpp"
#include "search/cell_grid.hpp"
#include "search/displacement.hpp"
#include "search/fixed_point.hpp"
#include "search/neighbour_list.hpp"
#include "search/side_images.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// What the search must find: all pairs closer than `support` [m]. Where supports vary, particle i
/// has its own, `supports` times its smoothing length, and a pair that of its mean, or the larger
/// one. A pair with a wall has that of the fluid particle, but no less than `support`.
struct SearchSettings {
  int dimension = 3;
  double support = 0.0;   // m; where supports vary, about
  double supports = 0.0;  // support by smoothing length; 0: all have `support`
  bool larger_of_two = false;
  FixedPoint fixed_point;
  DomainSides sides;
  bool walls_move = false;
};

/// How far the lists reach beyond the support [m], chosen anew at each rebuild.
struct Skins {
  double fluid = 0.0;
  double wall = 0.0;
};

/// Lists live as long as no two neighbours can have moved by the skin against each other; the skins
/// are chosen at each rebuild from the motion seen so far, so that rebuilding and the longer lists
/// cost about the same. Everything is a pure function of the particles' history, hence the same for
/// any number of threads.
///
/// Indices in the lists count the points of a kind from zero, owned points first, then images.
class Search {
 public:
  explicit Search(SearchSettings const& settings);

  /// Particles that passed planes and changed places with their images, since the start; what that
  /// added to their momentum [N s], where the plane is a wall.
  struct Reflections {
    std::uint64_t count = 0;
    std::array<double, 3> impulse{};
  };

  /// Whether the lists hold all neighbours at the positions in the store. Call once per step: how
  /// fast they wear out decides about the next skins. Positions of any size are allowed.
  bool lists_hold(ParticleStore const& store);

  /// Sorts the store by cells and makes the lists anew; particles that passed a periodic side or a
  /// symmetry plane come back in. Particles must lie inside the domain along all other sides.
  void rebuild(ParticleStore& store);

  /// Call when wall particles were removed: they are sorted and listed anew.
  void forget_walls() { walls_sorted_ = false; }

  /// Rebuilds where the lists do not hold; returns true then.
  bool refresh(ParticleStore& store) {
    if (lists_hold(store)) return false;
    rebuild(store);
    return true;
  }

  /// A place to look at particles from instead of looking at their images.
  struct Viewpoint {
    std::array<double, 3> place{};        // m
    std::array<double, 3> sign{1, 1, 1};  // of the velocity that the image shows, along each axis
  };

  /// Calls visit(i, from) for all fluid particles that may be closer to x [m] than `reach` [m], and
  /// for some that are not, while the lists hold: particle i, and the viewpoint, which is x moved
  /// by whole periods and reflected at symmetry planes. Images at walls are no fluid.
  template <class Visit>
  void for_each_fluid_near(std::array<double, 3> const& x, double reach, Visit&& visit) const;

  /// Saves or restores what the lists are a function of: where the points were when the lists were
  /// made, and how far they reach. Restoring needs the store restored before, and makes the same
  /// lists again.
  void exchange(Archive& archive, ParticleStore& store);

  Reflections const& reflections() const { return reflections_; }

  /// Neighbours of the fluid: itself with its images at periodic sides and symmetry planes; its
  /// images at walls; wall particles with their images.
  NeighbourList const& fluid_fluid() const { return fluid_fluid_; }
  NeighbourList const& fluid_mirrored() const { return fluid_mirrored_; }
  NeighbourList const& fluid_wall() const { return fluid_wall_; }
  NeighbourList const& wall_fluid() const { return wall_fluid_; }
  /// Wall points that have fluid near, ascending.
  std::vector<std::uint32_t> const& wet_walls() const { return wet_walls_; }
  std::vector<Image> const& images(Kind kind) const { return points(kind).images; }
  SearchSettings const& settings() const { return settings_; }
  Skins const& skins() const { return skins_; }
  /// The largest support while the lists hold [m].
  double largest_support() const {
    return varies() ? largest_support_ * settings_.fixed_point.scale +
                          std::max(skins_.fluid, skins_.wall)
                    : settings_.support;
  }
  std::uint64_t rebuilds() const { return rebuilds_; }
  std::size_t bytes() const;

 private:
  struct Points {
    std::size_t owned = 0;
    std::array<std::vector<Units>, 3> x;  // of the owned points, in cell order after a rebuild
    CellGrid grid;
    // With periodic or symmetric sides only: images, and owned points and images together in cell
    // order.
    std::vector<Image> images;
    std::vector<std::uint8_t> at_wall;  // of the images: 1 or 0; empty without mirror walls
    std::array<std::vector<Units>, 3> mixed_x;
    std::vector<std::uint32_t> mixed_index;
    // Where supports vary: of the owned points, and of owned points and images in cell order.
    std::vector<float> support;  // units
    std::vector<float> mixed_support;

    UnitSpans spans() const;
    CellPoints in_cells() const;
  };
  Points const& points(Kind kind) const { return points_[static_cast<std::size_t>(kind)]; }
  Points& points(Kind kind) { return points_[static_cast<std::size_t>(kind)]; }

  bool varies() const { return settings_.supports > 0.0; }
  void read_units(ParticleStore const& store, Kind kind);
  void read_supports(ParticleStore const& store);
  void find_largest_support(ParticleStore const& store);
  void list_supports(ParticleStore const& store);
  double growth_of_supports() const;
  void bring_back(ParticleStore& store, Kind kind);
  void swap_with_images(ParticleStore& store, std::size_t axis);
  double reach() const;  // units, of the lists
  GridShape shape_around(Kind kind, double reach) const;
  std::span<std::uint32_t const> cell_order(ParticleStore const& store, Kind kind, double reach);
  void sort(ParticleStore& store, Kind kind, double reach);
  void exchange_reference(Archive& archive, ParticleStore const& store, Kind kind);
  void exchange_supports(Archive& archive, ParticleStore const& store);
  void expect_order(ParticleStore const& store, Kind kind, double reach);
  void sort_walls(ParticleStore& store);
  MovingPoints moving_points() const;
  void mix_images(ParticleStore const& store, Kind kind);
  void choose_skins();
  void make_lists(ParticleStore const& store);
  template <int D>
  void collect_neighbours();

  SearchSettings settings_;
  std::array<Points, kind_count> points_;
  std::vector<float> listed_support_;  // units, of the fluid when the lists were made
  double largest_support_ = 0.0;       // units, of those
  NeighbourList fluid_fluid_, fluid_mirrored_, fluid_wall_, wall_fluid_;
  Reflections reflections_;
  DisplacementBound displacement_;
  DisplacementBound::Largest seen_;
  Skins skins_;
  CellSort sort_by_cells_;
  struct {
    std::array<std::vector<Units>, 3> x;
    std::vector<std::uint64_t> key;
  } mixing_;  // owned points and images before they are sorted
  bool walls_sorted_ = false;
  double wall_reach_ = 0.0;  // units, when the walls were sorted
  std::vector<std::uint32_t> wet_walls_;
  std::uint64_t steps_since_rebuild_ = 0;
  std::uint64_t rebuilds_ = 0;
};

template <class Visit>
void Search::for_each_fluid_near(std::array<double, 3> const& x, double reach,
                                 Visit&& visit) const {
  auto const dimension = static_cast<std::size_t>(settings_.dimension);
  Points const& fluid = points(Kind::fluid);
  auto const owned = static_cast<std::uint32_t>(fluid_fluid_.size());
  DomainSides const& sides = settings_.sides;
  // The cells hold places as of the last rebuild.
  double const wide = reach + displacement_.longest_motion() * settings_.fixed_point.scale;
  std::array<int, 3> most{};  // images to look from, along each axis and both ways
  for (std::size_t k = 0; k < dimension; ++k) {
    if (sides.periodic[k]) most[k] = static_cast<int>(std::ceil(wide / sides.length[k]));
    if (sides.is_symmetric(k, 0) || sides.is_symmetric(k, 1)) most[k] = 1;
  }
  for (int sz = -most[2]; sz <= most[2]; ++sz)
    for (int sy = -most[1]; sy <= most[1]; ++sy)
      for (int sx = -most[0]; sx <= most[0]; ++sx) {
        std::array<int, 3> const shift{sx, sy, sz};
        Viewpoint from{x};
        std::array<double, 3> low{}, high{};  // units
        bool exists = true;
        for (std::size_t k = 0; k < dimension; ++k) {
          if (shift[k] != 0) from.place[k] = sides.image_place(x[k], shift[k], k);
          if (sides.reverses(shift[k], k)) {
            from.sign[k] = -1.0;
            exists = exists && sides.is_symmetric(k, shift[k] > 0 ? 1 : 0);
          }
          double const center = settings_.fixed_point.center[k];
          low[k] = (from.place[k] - wide - center) / settings_.fixed_point.scale;
          high[k] = (from.place[k] + wide - center) / settings_.fixed_point.scale;
        }
        if (!exists) continue;
        fluid.in_cells().for_each_in_box(low, high, [&](std::uint32_t i) {
          if (i < owned) visit(static_cast<std::size_t>(i), from);  // images: by viewpoints
        });
      }
}

}  // namespace moraine
