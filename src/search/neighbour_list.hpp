// Neighbour lists: for each point, the indices of all points of one kind within a radius.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel_for.hpp"
#include "base/simd_width.hpp"
#include "search/cell_grid.hpp"
#include "search/record_slots.hpp"

namespace moraine {

/// A buffer of indices that one thread fills while it makes lists.
class IndexBuffer {
 public:
  /// Where to write next, with room for `count` indices.
  std::uint32_t* room(std::size_t count) {
    if (used_ + count > indices_.size()) indices_.resize(2 * (used_ + count));
    return indices_.data() + used_;
  }
  void advance(std::size_t count) { used_ += count; }
  void clear() { used_ = 0; }
  template <class Keep>
  void keep_if(Keep&& keep) {
    auto const end = indices_.begin() + static_cast<std::ptrdiff_t>(used_);
    auto const kept =
        std::remove_if(indices_.begin(), end, [&](std::uint32_t j) { return !keep(j); });
    used_ = static_cast<std::size_t>(kept - indices_.begin());
  }
  std::span<std::uint32_t> content() { return {indices_.data(), used_}; }
  std::size_t bytes() const { return indices_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> indices_;
  std::size_t used_ = 0;
};

/// Points that may be neighbours of the points in one cell.
struct CandidateCache {
  std::array<std::vector<Units>, 3> x;  // [axis][candidate], padded to whole vectors
  std::vector<std::uint32_t> index;
  std::vector<float> support;  // units, where radii of pairs depend on it
  std::size_t count = 0;
  std::array<int, 3> cell{};
  bool valid = false;

  std::size_t bytes() const {
    return (x[0].capacity() + x[1].capacity() + x[2].capacity() + index.capacity() +
            support.capacity()) *
           4;
  }
};

/// One list: groups of `lanes` record slots, each slot a base plus a 16-bit offset.
struct NeighbourGroups {
  std::uint32_t const* bases = nullptr;    // [group]
  std::uint16_t const* offsets = nullptr;  // [group * lanes + lane]
  std::size_t count = 0;                   // groups
  bool empty() const { return count == 0; }
};

/// Lists of consecutive points, kept in blocks that grow and never shrink.
///
/// A list is cut into groups of lanes() neighbours whose record slots lie within 65536 of each
/// other; a group that is not full is padded with a record that lies nowhere (record_slots.hpp), so
/// that the pair loops need neither a remainder nor a mask. Inside a list, neighbours stand in
/// ascending order of their slots.
class NeighbourList {
 public:
  static constexpr std::size_t block = 256;

  /// Lanes of a group: half-width registers where lists are short.
  static constexpr std::size_t lanes(int dimension) {
    return dimension == 3 && widest_float > 8 ? widest_float : 8;
  }

  NeighbourGroups of(std::size_t i) const {
    Block const& b = blocks_[i / block];
    std::size_t const k = i % block;
    std::size_t const first = b.start[k];
    return {b.bases.data() + first, b.offsets.data() + first * lanes_, b.start[k + 1] - first};
  }
  std::size_t size() const { return size_; }
  std::size_t lanes() const { return lanes_; }

  /// Points in the list of point i, padding left out; for tests and for counting.
  std::vector<std::uint32_t> points(std::size_t i) const;

  /// Makes the lists of `count` points in groups of `lanes`: `collect(i, candidates, buffer)`
  /// appends the neighbours of point i, in ascending order unless `unsorted`.
  template <class Collect>
  void build(std::size_t count, std::size_t lanes, bool unsorted, Collect&& collect);

  std::size_t bytes() const;

 private:
  struct Block {
    std::vector<std::uint32_t> bases;
    std::vector<std::uint16_t> offsets;
    std::vector<std::uint32_t> start;  // first group of each point
  };
  struct Scratch {
    CandidateCache candidates;
    IndexBuffer found;
    std::vector<std::uint32_t> bases;
    std::vector<std::uint16_t> offsets;
  };
  void encode(std::span<std::uint32_t> points, Scratch& scratch) const;
  void store(Block& block, Scratch const& scratch) const;

  std::vector<Block> blocks_;
  std::vector<Scratch> scratch_;  // one per thread
  std::size_t size_ = 0;
  std::size_t lanes_ = 8;
};

/// How near a pair must be: within one radius, or within that of the supports of the two. Alone,
/// a support counts as no less than `least`.
enum class PairRadius : std::uint8_t { same, of_self, of_other, mean, larger };

/// Finds the neighbours of points among points sorted by cell.
///
/// Points of one cell share their candidates: these are copied side by side once per cell, and each
/// point then walks one plain array, without rows to look up and without a remainder per row.
template <int D>
class NeighbourFinder {
 public:
  /// `radius` [units]: no pair may be farther apart. `skin` [units] is added to the supports.
  explicit NeighbourFinder(CellPoints const& points, double radius,
                           PairRadius of_pair = PairRadius::same, float skin = 0.0F,
                           float least = 0.0F);

  /// Appends the indices of all points within the radius of x, except `self`, whose support is
  /// `support` [units]. Quick when x lies in the same cell as in the call before with this cache.
  void operator()(UnitPoint const& x, std::uint32_t self, CandidateCache& cache,
                  IndexBuffer& buffer, float support = 0.0F) const;

 private:
  bool asks_supports() const {
    return of_pair_ != PairRadius::same && of_pair_ != PairRadius::of_self;
  }
  void gather(std::array<int, 3> const& cell, CandidateCache& cache) const;
  template <class Float>
  Float radius_squared(float support, float const* supports) const;

  CellPoints points_;
  double radius_;
  float radius2_;
  PairRadius of_pair_;
  float skin_;
  float least_;
};

template <class Collect>
void NeighbourList::build(std::size_t count, std::size_t lanes, bool unsorted, Collect&& collect) {
  size_ = count;
  lanes_ = lanes;
  std::size_t const blocks = (count + block - 1) / block;
  if (blocks_.size() < blocks) blocks_.resize(blocks);
  if (scratch_.size() < thread_count()) scratch_.resize(thread_count());
  for_each_block(count, block, [&](std::size_t begin, std::size_t end) {
    Scratch& scratch = scratch_[thread_index()];
    scratch.candidates.valid = false;
    scratch.bases.clear();
    scratch.offsets.clear();
    Block& b = blocks_[begin / block];
    b.start.resize(block + 1);
    b.start[0] = 0;
    for (std::size_t i = begin; i < end; ++i) {
      scratch.found.clear();
      collect(i, scratch.candidates, scratch.found);
      auto const found = scratch.found.content();
      if (unsorted) std::sort(found.begin(), found.end());
      encode(found, scratch);
      b.start[i - begin + 1] = static_cast<std::uint32_t>(scratch.bases.size());
    }
    store(b, scratch);
  });
}

}  // namespace moraine
