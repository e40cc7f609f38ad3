// The height of the free surface of a body over a place of the plan.
#pragma once

#include <cstdint>
#include <span>

#include "base/vec3.hpp"
#include "probes/selection.hpp"
#include "search/search.hpp"
#include "smoothing/kernel_names.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// A body of particles as a surface is seen of it.
struct BodyView {
  ParticleStore const& store;
  Search const& search;
  KernelName kernel;
  double h;                               // m
  std::span<std::uint8_t const> members;  // of the fluid particles: 1 or 0
  Upwards up;
};

/// Where a body is met on the way down over a place of the plan: with s(x) the share of the kernel
/// that the body fills (filled_share.hpp), looked at from `top` downwards in steps of h / 4, the
/// first place at which s is a tenth begins a stretch of 4 h; the surface is the highest place of
/// it at which s is half of the largest s there (one half, where that is above one). So it is that
/// of the gauge `level` for a body that is thicker than 4 h. Not a number where s stays below a
/// tenth down to `bottom`. Heights in m.
double surface_height(BodyView const& view, Vec3 const& place, double top, double bottom);

/// Heights of the lowest and the highest particle of a body [m]; low > high where it has none.
struct HeightRange {
  double low, high;
};
HeightRange heights_of(BodyView const& view);

}  // namespace moraine
