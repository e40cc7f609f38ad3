#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace moraine {

/// Allocates on cache-line boundaries, so that quads of a record never straddle two lines.
template <class T>
struct CacheAligned {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheAligned() = default;
  template <class U>
  explicit CacheAligned(CacheAligned<U> const&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), alignment));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete(memory, alignment); }
  bool operator==(CacheAligned const&) const { return true; }
};

template <class T>
using AlignedVector = std::vector<T, CacheAligned<T>>;

}  // namespace moraine
