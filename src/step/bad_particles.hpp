// Loops that look for particles with something wrong.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/parallel_for.hpp"
#include "step/guard.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// No index of a particle.
inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

/// Lowest index below `count` for which a particle is bad; `none` when all are good.
template <class Bad>
std::size_t first_bad(std::size_t count, Bad&& bad) {
  auto const in_block = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (bad(i)) return i;
    return none;
  };
  return reduce_blocks(count, none, in_block,
                       [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

/// All bad particles below `count`, equally bad. Serial: a run that asks is over.
template <class Bad>
std::vector<Suspect> all_bad(std::size_t count, Bad&& bad) {
  std::vector<Suspect> suspects;
  for (std::size_t i = 0; i < count; ++i)
    if (bad(i)) suspects.push_back({i, 0.0});
  return suspects;
}

using Components = std::array<std::span<double const>, 3>;

/// Components of a vector field; empty beyond the dimension.
inline Components components_of(ParticleStore const& store, Field field) {
  Components result;
  for (int axis = 0; axis < store.dimension(); ++axis)
    result[static_cast<std::size_t>(axis)] = store.component(field, axis);
  return result;
}

/// Square of the length of a particle's vector.
inline double square_of(Components const& vector, std::size_t i) {
  double sum = 0.0;
  for (auto const& component : vector)
    if (!component.empty()) sum += component[i] * component[i];
  return sum;
}

}  // namespace moraine
