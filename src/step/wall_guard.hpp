// Particles inside walls.
#pragma once

#include <vector>

#include "search/search.hpp"
#include "step/guard.hpp"
#include "store/particle_store.hpp"
#include "terms/pair_backend.hpp"

namespace moraine {

/// What the guard of walls looks at. Lists must hold.
struct WallGuardView {
  ParticleStore const& store;
  Search const& search;
  WallData const& walls;
};

/// Largest depth [m] behind a face at which a particle is for sure; 0 where none is deeper than
/// `bound` [m].
///
///   depth_i >= max over wall particles w with |x_i - x_w| < clearance_w of depth_w - |x_i - x_w|
///
/// A bound from below that needs nothing but the wall particles, so that it holds for walls of any
/// shape, that move or are gone: around each of them there is a ball of solid, and depth changes by
/// no more than the way. Between two wall particles a particle may be deeper by up to 0.3 spacings
/// than it says, with three layers or more.
double deepest_in_walls(WallGuardView const& view, double bound);

/// The particles deeper than `bound` [m]; their badness is the depth. In the order of the store.
std::vector<Suspect> deeper_in_walls(WallGuardView const& view, double bound);

}  // namespace moraine
