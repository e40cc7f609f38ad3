// Stages of a run: what changes when one begins, what is different while it lasts, when it ends.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "store/particle_store.hpp"

namespace moraine {

class Simulation;

/// A pressure [Pa], interpolated at a fixed place, that ends a stage.
struct PressureLimit {
  std::array<double, 3> position{};  // m
  double pressure = 0.0;             // Pa
  bool above = true;                 // ends when it is higher; else when it is lower
};

/// When a stage ends: as soon as one of these holds. A stage without any lasts to the end.
struct StageEnd {
  double after = std::numeric_limits<double>::infinity();  // s since the stage began
  /// m/s, sqrt(2 E_kin / M) of all fluid: the kinetic energy is below a bound; 0: not looked at.
  double rms_speed_below = 0.0;
  double steady_for = 0.0;  // s: for how long it must have been below
  std::optional<PressureLimit> pressure;
};

/// Particles that become another material: a charge that detonates. Their density stays, their
/// specific energy [J/kg] is set.
struct Transformation {
  std::vector<std::uint64_t> ids;  // ascending
  MaterialId material = 0;
  double specific_energy = 0.0;
};

struct Stage {
  std::string name;
  double damping = 0.0;  // 1/s: acceleration - damping v; kinetic energy falls with twice this rate
  StageEnd end;
  std::vector<std::uint64_t> removed_walls;  // ids of wall particles, ascending
  std::vector<Transformation> transformations;
};

/// A stage that has begun: when, and why the one before it ended.
struct StageEvent {
  std::string stage;
  double time = 0.0;  // s
  std::uint64_t step = 0;
  std::string cause;
};

/// Which stage a run is in, and for how long its end has been near.
class Stages {
 public:
  /// Conditions that cost a pass over the particles are looked at every so many steps.
  static constexpr std::uint64_t look_interval = 10;

  explicit Stages(std::vector<Stage> stages) : stages_(std::move(stages)) {}

  /// The stage that the run is in; nothing for a run without stages.
  Stage const* current() const { return stages_.empty() ? nullptr : &stages_[index_]; }
  double damping() const { return stages_.empty() ? 0.0 : stages_[index_].damping; }  // 1/s

  /// Why the present stage ends now; empty if it goes on, or is the last one.
  std::string ended(Simulation const& simulation);

  /// Notes that the first, or the next, stage begins.
  void begin_first();
  void begin_next(double time, std::uint64_t step, std::string cause);

  std::vector<StageEvent> const& events() const { return events_; }

  /// All stages of the run, begun or not.
  std::vector<Stage> const& all() const { return stages_; }

  /// How many stages have not begun yet.
  std::size_t to_come() const { return stages_.empty() ? 0 : stages_.size() - 1 - index_; }
  void exchange(Archive& archive);

 private:
  std::vector<Stage> stages_;
  std::size_t index_ = 0;
  double began_ = 0.0;       // s
  double fast_until_ = 0.0;  // s: last look at which the speed was not below the bound
  std::vector<StageEvent> events_;
};

}  // namespace moraine
