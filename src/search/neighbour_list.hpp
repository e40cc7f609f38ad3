// Neighbour lists: for each point, the indices of all points of one kind within a radius.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel_for.hpp"
#include "search/cell_grid.hpp"

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
  std::span<std::uint32_t const> content() const { return {indices_.data(), used_}; }
  std::size_t bytes() const { return indices_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> indices_;
  std::size_t used_ = 0;
};

/// Lists of consecutive points, kept in blocks that grow and never shrink.
///
/// Every list is padded to a multiple of `lanes` with the index of a point that lies nowhere, so
/// that the pair loops need no remainder. Inside a list, indices stand in the order of the cells.
class NeighbourList {
 public:
  static constexpr std::size_t block = 256;
  static constexpr std::size_t lanes = 16;

  /// Padded list of point i.
  std::span<std::uint32_t const> of(std::size_t i) const {
    Block const& b = blocks_[i / block];
    std::size_t const k = i % block;
    return {b.indices.data() + b.start[k], b.start[k + 1] - b.start[k]};
  }
  std::size_t size() const { return size_; }

  /// Makes the lists of `count` points: `collect(i, buffer)` appends the neighbours of point i;
  /// `nowhere` pads.
  template <class Collect>
  void build(std::size_t count, std::uint32_t nowhere, Collect&& collect);

  std::size_t bytes() const;

 private:
  struct Block {
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> start;
  };
  void store(std::size_t index, std::span<std::uint32_t const> indices);

  std::vector<Block> blocks_;
  std::vector<IndexBuffer> scratch_;  // one per thread
  std::size_t size_ = 0;
};

/// Finds neighbours of a point among the entries of a grid.
template <int D>
class RowCollector {
 public:
  /// radius in units.
  RowCollector(CellGrid const& grid, double radius);

  /// Appends the indices of all points within the radius of x, except `self`.
  void operator()(UnitPoint const& x, std::uint32_t self, IndexBuffer& buffer) const;

 private:
  void row(UnitPoint const& x, std::uint32_t self, std::size_t begin, std::size_t end,
           IndexBuffer& buffer) const;

  CellGrid const& grid_;
  double radius_;
  float radius2_;
};

template <class Collect>
void NeighbourList::build(std::size_t count, std::uint32_t nowhere, Collect&& collect) {
  size_ = count;
  std::size_t const blocks = (count + block - 1) / block;
  if (blocks_.size() < blocks) blocks_.resize(blocks);
  if (scratch_.size() < thread_count()) scratch_.resize(thread_count());
  for_each_block(count, block, [&](std::size_t begin, std::size_t end) {
    IndexBuffer& buffer = scratch_[thread_index()];
    buffer.clear();
    Block& b = blocks_[begin / block];
    b.start.resize(block + 1);
    b.start[0] = 0;
    for (std::size_t i = begin; i < end; ++i) {
      collect(i, buffer);
      std::size_t const odd = buffer.content().size() % lanes;
      if (odd != 0) {
        std::fill_n(buffer.room(lanes - odd), lanes - odd, nowhere);
        buffer.advance(lanes - odd);
      }
      b.start[i - begin + 1] = static_cast<std::uint32_t>(buffer.content().size());
    }
    store(begin / block, buffer.content());
  });
}

}  // namespace moraine
