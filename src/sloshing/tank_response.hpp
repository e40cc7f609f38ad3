// What a record does to the liquid in a rigid tank, by linear theory.
#pragma once

#include <vector>

#include "records/ground_record.hpp"
#include "sloshing/rigid_tank.hpp"

namespace moraine {

/// How the response is computed.
struct ResponseSettings {
  double damping = 0.005;  // ratio of all modes, 0 to 1; water in clean tanks: about 0.005
  int modes = 40;          // odd modes, n = 1, 3, 5, ...
  double free_time = 0.0;  // s, after the end of the record, over resting ground
};

/// Histories at the times of the record, and on through the free time. x points along the motion,
/// from the middle of the tank.
struct TankResponse {
  GroundRecord ground;                 // the record, with zeros for the free time
  std::vector<double> surface;         // m, above still water, at the wall x = +L/2
  std::vector<double> force;           // N, of the liquid on the tank, along x, without weight
  std::vector<double> wall_moment;     // N m, of the pressure on both walls, about the floor
  std::vector<double> turning_moment;  // N m, of that on walls and floor, about the floor's middle
};

/// The sum over the modes, each an oscillator solved exactly (Oscillator; Duhamel's integral):
///   D_n'' + 2 zeta w_n D_n' + w_n^2 D_n = -a(t),  n = 1, 3, 5, ...
///   surface = sum 4 L / (n^2 pi^2) (w_n^2/g) D_n,  at -L/2 with the other sign
///   force   = -m a - sum m_n D_n''
///   moments = -m h a - sum m_n h_n D_n'', with the heights of rigid_tank.hpp
/// Modes that are left out count as moving with the tank. Range: waves that are small against
/// length and depth; linear theory gives symmetric ones, nature higher crests. Throws
/// std::invalid_argument for a bad tank, record, damping or number of modes.
TankResponse tank_response(RigidTank const& tank, GroundRecord const& record,
                           ResponseSettings const& settings);

/// Largest and smallest values of a history, with their first times.
struct Range {
  double largest = 0.0, largest_time = 0.0;    // unit of the history, s
  double smallest = 0.0, smallest_time = 0.0;  // unit of the history, s
  double size() const;                         // larger magnitude
};

Range range_of(GroundRecord const& ground, std::vector<double> const& history);

}  // namespace moraine
