// The particle store: one array of doubles per field component, kinds in contiguous ranges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "store/field.hpp"

namespace moraine {

/// Kinds lie one after the other in the store, in this order.
enum class Kind : std::uint8_t { fluid, wall };
inline constexpr std::size_t kind_count = 2;

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t size() const { return end - begin; }
};

using MaterialId = std::uint8_t;
inline constexpr MaterialId no_material = 255;  // wall particles

/// State of all particles in double precision, structure of arrays.
///
/// Arrays of fields without `on_walls` cover the fluid only, which lies first.
/// Vectors and matrices are stored by component: component(Field::velocity, 1)[i] is v_y of
/// particle i [m/s]; see Rank for the order of the others. Global ids never change while particles
/// move in memory; they are the handle for everything that must survive a reordering. Spans are
/// invalidated by append, permute, remove and shrink.
class ParticleStore {
 public:
  explicit ParticleStore(int dimension);

  int dimension() const { return dimension_; }
  std::size_t size() const { return id_.size(); }
  Range range(Kind kind) const;

  std::span<double> scalar(Field field) { return component(field, 0); }
  std::span<double const> scalar(Field field) const { return component(field, 0); }
  std::span<double> component(Field field, int axis);
  std::span<double const> component(Field field, int axis) const;

  std::span<std::uint64_t const> id() const { return id_; }
  std::span<MaterialId const> material() const { return material_; }
  void set_material(std::size_t i, MaterialId material) { material_[i] = material; }

  /// Makes an optional field part of all fluid particles, present and to come; zero at first.
  void use(Field field);
  /// Whether the particles have this field; true for all that are not optional.
  bool has(Field field) const;

  /// Adds a zeroed particle at the end of its kind and returns its index; ids count upwards.
  /// Fluid particles must be appended before wall particles.
  std::size_t append(Kind kind, MaterialId material);

  /// New order of the particles of a kind, both counted from its first: particle k of the result
  /// was particle order[k].
  void permute(Kind kind, std::span<std::uint32_t const> order);

  /// Removes the particles with these ascending indices.
  void remove(std::span<std::uint32_t const> indices);

  /// Gives back what growing particle by particle has reserved too much, and working memory.
  void shrink();

  /// Saves or restores all particles in their present order, with the fields marked `saved`; other
  /// fields are zero after restoring. Optional fields are there afterwards if they were saved.
  void exchange(Archive& archive);

  /// Memory held by all arrays, in bytes.
  std::size_t bytes() const;

 private:
  std::vector<double>& array(Field field, int axis);
  void exchange_used(Archive& archive);
  void exchange_field(Archive& archive, FieldInfo const& field, int axis);

  int dimension_;
  std::array<std::size_t, kind_count> kind_size_{};
  std::vector<std::vector<double>>
      arrays_;  // [field * most_components + component], empty where unused
  std::vector<std::uint64_t> id_;
  std::vector<MaterialId> material_;
  std::uint64_t next_id_ = 0;
  std::array<bool, field_count> used_{};  // optional fields that the particles have
  std::vector<std::uint64_t> scratch_;    // for permute: one array of any type at a time
};

}  // namespace moraine
