// Which region a place belongs to.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setup/case.hpp"
#include "setup/layers.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// The regions of a case on the ground that walls and domain leave them.
class Territory {
 public:
  /// What a place is filled with.
  struct Owner {
    std::size_t region = 0;
    MaterialId material = no_material;
  };

  /// `c` must outlive the territory. Throws InputErrors for a material that the case does not have.
  explicit Territory(Case const& c);

  /// The last region around a point; nothing where there is none, outside the domain, in solid
  /// walls and, if there are container walls, outside all of them (an open side bounds nothing).
  std::optional<Owner> owner(Point const& point) const;

  /// Whether region i reaches a point, whatever later regions and walls say.
  bool reaches(std::size_t i, Point const& point) const { return material(i, point).has_value(); }

  /// The box that holds all particles.
  Box range() const;

  /// Points closer to a face count as on it [m].
  double tolerance() const { return tolerance_; }

 private:
  std::optional<MaterialId> material(std::size_t i, Point const& point) const;
  std::vector<MaterialId> materials_of(RegionSpec const& region) const;
  bool may_be_filled(Point const& point) const;
  bool in_any(std::vector<Box> const& boxes, Point const& point) const;

  Case const& case_;
  double tolerance_;
  std::optional<Upward> upward_;
  std::vector<std::vector<MaterialId>> materials_;  // of each region, layer by layer
  std::vector<double> tops_;                        // of the layers of each region [m]
  std::vector<Box> containers_;
  std::vector<Box> solids_;
};

}  // namespace moraine
