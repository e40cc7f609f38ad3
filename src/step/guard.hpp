// The guards of a run: what each looks at, and what it finds.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// In the order of their gravity: a particle that several guards meet is flagged for the first.
enum class Guard : std::uint8_t {
  finite,
  state,
  motion,
  clock,
  density,
  speed,
  energy,
  walls,
  budget,
  collapse
};

struct GuardInfo {
  Guard guard;
  std::string_view name;  // in messages and in `guards.off`
  bool optional;          // looked at every N steps, may be switched off; the others: every step
  std::string_view looks_at;
};

inline constexpr std::array guard_table{
    GuardInfo{Guard::finite, "finite", false, "numbers of the state that are none, density <= 0"},
    GuardInfo{Guard::state, "state", false, "states without a sound speed"},
    GuardInfo{Guard::motion, "motion", false, "motion beyond the smoothing length in one step"},
    GuardInfo{Guard::clock, "clock", false, "time steps that do not move the clock"},
    GuardInfo{Guard::density, "density", true, "density against those of the start"},
    GuardInfo{Guard::speed, "speed", true, "speed against the signal speed of the start"},
    GuardInfo{Guard::energy, "energy", true, "specific energy against that of the start"},
    GuardInfo{Guard::walls, "walls", true, "depth of particles inside walls"},
    GuardInfo{Guard::budget, "budget", true, "total energy against what is booked"},
    GuardInfo{Guard::collapse, "collapse", true, "time steps against that of sound at the start"},
};
inline constexpr std::size_t guard_count = guard_table.size();

constexpr GuardInfo const& info(Guard guard) {
  return guard_table[static_cast<std::size_t>(guard)];
}

/// What particles of a bad frame carry: 0 for the innocent, else this. In the order of the table.
constexpr int flag_of(Guard guard) { return static_cast<int>(guard) + 1; }

/// The table [guards] of a case. Why the defaults are what they are: docs/guards.md.
struct GuardSettings {
  int interval = 20;                  // steps between two looks
  std::vector<std::string> off;       // names of guards that do not look
  std::optional<double> compression;  // largest density by the densest of the start; by the law
  std::optional<double> expansion;    // thinnest density of the start by the least; by the spacing
  double speed = 10.0;                // by the largest signal speed of the start
  double specific_energy = 10.0;      // by the largest specific energy of the start
  double wall_depth = 0.5;            // spacings behind the face
  double energy_budget = 0.05;        // by the energy that the run has
  double time_step = 1e-3;            // by that of sound at the start

  bool looks(Guard guard) const;
};

/// A particle that a guard names: its index in the store, and how bad it is; the worst comes first,
/// equals in the order of the store.
struct Suspect {
  std::size_t particle = 0;
  double badness = 0.0;
};

/// What one guard has found. `cause` says of a particle what is wrong with it; where nobody is
/// named, it is asked for `no_particle`.
struct Finding {
  static constexpr std::size_t no_particle = static_cast<std::size_t>(-1);

  Guard guard = Guard::finite;
  std::vector<Suspect> suspects;
  std::function<std::string(std::size_t)> cause;
};

}  // namespace moraine
