// Gathered copies: the records of one kind of particle, refreshed once per step.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <type_traits>

#include "base/aligned_vector.hpp"
#include "base/parallel_for.hpp"
#include "search/search.hpp"
#include "store/particle_store.hpp"
#include "terms/pair_fields.hpp"

namespace moraine {

/// a - b [m] of two coordinates of records; `scale`: metres per fixed-point unit.
template <class Slot>
double metres_between(Slot a, Slot b, double scale) {
  if constexpr (std::is_same_v<Slot, float>)
    return (static_cast<double>(std::bit_cast<Units>(a)) -
            static_cast<double>(std::bit_cast<Units>(b))) *
           scale;
  else
    return a - b;
}

/// Records of owned particles, then of their images, in the slots of search/record_slots.hpp.
/// Positions are fixed-point units (kept as bits) for Slot float, metres for Slot double.
template <class Slot, class Layout>
class Records {
 public:
  static constexpr int D = Layout::dimension;
  static constexpr bool fixed = std::is_same_v<Slot, float>;

  /// smoothing_length [m]: an ordinary one, for the records that lie nowhere.
  explicit Records(double smoothing_length) : smoothing_length_(smoothing_length) {}

  void resize(std::size_t owned, std::size_t images) {
    owned_ = owned;
    std::size_t const slots = slots_for(owned + images);
    if (values_.size() == slots * Layout::stride) return;
    values_.resize(slots * Layout::stride);
    for (std::size_t slot = slot_page; slot < slots; slot += slot_page + 1) put_nowhere(slot);
  }

  Slot* record(std::size_t i) { return values_.data() + place(i); }
  Slot const* record(std::size_t i) const { return values_.data() + place(i); }
  Slot const* data() const { return values_.data(); }

  void set_position(std::size_t i, int axis, double x, FixedPoint const& map) {
    if constexpr (fixed)
      record(i)[axis] = std::bit_cast<float>(map.units(x, axis));
    else
      record(i)[axis] = x;
  }
  void set(std::size_t i, PairField field, double value, int component = 0) {
    record(i)[Layout::offset(field) + component] = static_cast<Slot>(value);
  }

  void reverse_velocity(std::size_t i, std::size_t axis) {
    Slot& component =
        record(i)[static_cast<std::size_t>(Layout::offset(PairField::velocity)) + axis];
    component = -component;
  }

  /// Undoes what the reflection along an axis has done to stresses.
  void reverse_stresses(std::size_t i, std::size_t axis) {
    if constexpr (Layout::has(PairField::stress_term))
      reverse_entries(record(i) + Layout::offset(PairField::stress_term), axis);
    if constexpr (Layout::has(PairField::artificial_stress))
      reverse_entries(record(i) + Layout::offset(PairField::artificial_stress), axis);
  }

  double get(std::size_t i, PairField field, int component = 0) const {
    return static_cast<double>(record(i)[Layout::offset(field) + component]);
  }

  /// A record as the plain loop in double reads it; positions in metres from the place where
  /// fixed-point units are zero. scale: metres per unit.
  std::array<double, Layout::stride> in_metres(std::size_t i, double scale) const {
    std::array<double, Layout::stride> numbers{};
    Slot const* const from = record(i);
    for (std::size_t k = 0; k < Layout::stride; ++k) {
      bool const place = fixed && k < static_cast<std::size_t>(D);
      numbers[k] = place ? std::bit_cast<Units>(static_cast<float>(from[k])) * scale
                         : static_cast<double>(from[k]);
    }
    return numbers;
  }

  /// Copies records to their images, with what moving or reflecting them changes.
  void refresh(std::vector<Image> const& images, DomainSides const& sides) {
    for_each_block(images.size(), loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        Slot* const to = record(owned_ + k);
        Slot const* const from = record(images[k].source);
        std::copy(from, from + Layout::stride, to);
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis) {
          int const shift = images[k].shift[axis];
          if (shift == 0) continue;
          if constexpr (fixed)
            to[axis] = std::bit_cast<float>(
                sides.image_units(std::bit_cast<Units>(from[axis]), shift, axis));
          else
            to[axis] = sides.image_place(from[axis], shift, axis);
          if (sides.reverses(shift, axis)) reverse(to, axis);
        }
      }
    });
  }

  std::size_t owned() const { return owned_; }
  std::size_t bytes() const { return values_.capacity() * sizeof(Slot); }

 private:
  static std::size_t place(std::size_t i) {
    return slot_of(static_cast<std::uint32_t>(i)) * Layout::stride;
  }

  /// What reflecting a particle along an axis does to its fields.
  static void reverse(Slot* record, std::size_t axis) {
    for (std::size_t f = 0; f < pair_field_count; ++f) {
      auto const field = static_cast<PairField>(f);
      if (!Layout::has(field) || rank(field) == PairRank::scalar) continue;
      Slot* const values = record + Layout::offset(field);
      if (rank(field) == PairRank::vector) {
        values[axis] = -values[axis];
        continue;
      }
      reverse_entries(values, axis);
    }
  }

  /// The entries of a symmetric matrix that change their sign where an axis does.
  static void reverse_entries(Slot* matrix, std::size_t axis) {
    for (std::size_t other = 0; other < static_cast<std::size_t>(D); ++other)
      if (other != axis) {
        Slot& shared = matrix[symmetric_index<D>(axis, other)];
        shared = -shared;
      }
  }

  void put_nowhere(std::size_t slot) {
    Slot* const last = values_.data() + slot * Layout::stride;
    for (std::size_t k = 0; k < Layout::stride; ++k) last[k] = Slot(0);
    for (int axis = 0; axis < D; ++axis)
      last[axis] = fixed ? std::bit_cast<float>(FixedPoint::nowhere) : Slot(1e15);
    // A density of one keeps the pair's division finite.
    if constexpr (Layout::has(PairField::reference_density))
      last[Layout::offset(PairField::reference_density)] = Slot(1);
    if constexpr (Layout::has(PairField::volume))
      last[Layout::offset(PairField::mass)] = last[Layout::offset(PairField::volume)] = Slot(1);
    if constexpr (Layout::has(PairField::smoothing_length))
      last[Layout::offset(PairField::smoothing_length)] = static_cast<Slot>(smoothing_length_);
  }

  AlignedVector<Slot> values_;
  std::size_t owned_ = 0;
  double smoothing_length_;  // m
};

}  // namespace moraine
