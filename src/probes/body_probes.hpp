// Size and place of bodies of particles: deposits, gas bubbles, surfaces that rise.
#pragma once

#include <optional>

#include "probes/selection.hpp"
#include "probes/surface_height.hpp"

namespace moraine {

/// How a deposit is measured: along an axis (direction +1 or -1), or round about the origin.
struct DepositFrame {
  Upwards up;
  double base = 0.0;  // m, height of the floor
  Vec3 origin{};      // m
  std::optional<Upwards> along;
};

struct DepositReading {
  double run_out;      // m
  double height;       // m
  double front_angle;  // rad, against the horizontal
};

/// Run-out: the farthest end of a particle of the body from the origin, along the axis or by the
/// horizontal distance; height: the highest end above the base. A particle ends half its size
/// (size_of_particle) from its place. Front angle: of the line from the front at the base to the
/// farthest end of what reaches half the height, atan(height / 2 / (run_out - reach_half)); pi / 2
/// for an upright front. Not numbers where the body has no particle.
DepositReading probe_deposit(ParticleStore const& store, std::span<std::uint8_t const> members,
                             DepositFrame const& frame);

struct BubbleReading {
  double volume = 0.0;  // m^d: sum of m / rho
  double radius = 0.0;  // m, of the ball (disc, half of the piece) with this volume
  Vec3 center{};        // m, mean place, weighted by volume
  Vec3 low{}, high{};   // m, the outermost ends along the axes, half a size from the places
};

/// Of the selected particles, connected or not. Places are not numbers where there are none.
/// `copies`: how many times the domain fits into the whole (Symmetry::copies); volume and radius
/// are those of the whole, places those of the part in the domain.
BubbleReading probe_bubble(ParticleStore const& store, Selection const& gas, int copies);

/// The highest surface (surface_height) of a body over the places of a grid, about h / 2 wide, that
/// lies in the box [m]. Not a number where there is none.
double probe_highest(BodyView const& view, PlaceBox const& within);

}  // namespace moraine
