// What hangs together: the bulk of a body, without the pieces that fly off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/search.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// The bulk of a body, and what is detached from it.
struct ConnectedBody {
  std::vector<std::uint8_t> members;  // of the fluid particles: 1 in the bulk, 0 elsewhere
  std::size_t particles = 0;          // in the bulk
  std::size_t detached = 0;           // particles
  double mass = 0.0;                  // kg, of the bulk
  double detached_mass = 0.0;         // kg
  /// Share of the mass that is detached; 0 where there is nothing.
  double detached_share() const {
    double const all = mass + detached_mass;
    return all > 0.0 ? detached_mass / all : 0.0;
  }
};

/// The heaviest group of chosen particles that hang together: each is closer than the support,
/// kernel_support h, to another of the group (with varying smoothing lengths h is the mean of the
/// two), also across periodic sides. `chosen`: 1 or 0 for each fluid particle; h in m. The lists of
/// the search must hold. A function of the particles alone: the same for any number of threads.
ConnectedBody connected_body(ParticleStore const& store, Search const& search, double h,
                             std::span<std::uint8_t const> chosen);

}  // namespace moraine
