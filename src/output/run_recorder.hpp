// Everything a run writes into its folder, and when each piece is due.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "base/timer.hpp"
#include "output/manifest.hpp"
#include "output/plane_recorder.hpp"
#include "output/probe_recorder.hpp"
#include "output/pvd_collection.hpp"
#include "output/table_csv.hpp"
#include "output/vote_tally.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"
#include "step/simulation_error.hpp"

namespace moraine {

/// Columns of the table of conserved sums.
std::vector<TableColumn> sums_columns();

/// Times at which something is due: multiples of an interval, listed times; every step when the
/// interval is zero. A due time is met by the first step at or after it, so that output never
/// changes a time step.
class Schedule {
 public:
  Schedule(double interval, std::vector<double> times, bool every_step);

  /// True when something is due at this time; then advances to the next.
  bool due(double time);

 private:
  double interval_;
  std::vector<double> times_;
  bool every_step_;
  double next_ = 0.0;
  std::size_t next_listed_ = 0;
};

/// What a recorder must know to go on where another one was: how much had been written.
struct RecorderState {
  std::vector<double> frame_times;  // s
  std::uint64_t gauges_size = 0;    // bytes
  std::uint64_t sums_size = 0;
  double last_gauge_time = -1.0;  // s
  double last_sums_time = -1.0;
  double wall_time = 0.0;  // s, of all parts of the run so far
  Manifest manifest;       // of the start

  void exchange(Archive& archive);
};

/// Writes frames, gauges, conserved sums, the used case and the manifest of one run.
class RunRecorder {
 public:
  /// Writes the used case, copies of the STL files that it names, the manifest, the walls and the
  /// state at the start into a folder made by make_run_folder. Throws OutputError, like all below,
  /// where something cannot be written.
  RunRecorder(Case const& c, Simulation const& simulation, std::filesystem::path folder,
              int threads);

  /// Goes on in a folder as it was when `saved` was the state: what was written later is dropped.
  RunRecorder(Case const& c, Simulation const& simulation, std::filesystem::path folder,
              int threads, RecorderState const& saved);

  RecorderState state() const;

  /// The case with names of files that count from the folder of the run.
  Case const& kept_case() const { return case_; }

  /// Saves or restores what the gauges and the tally of votes remember.
  void exchange_memory(Archive& archive);

  /// Hands what has been written to the disk.
  void sync();

  /// Call after each step.
  void tell(Simulation const& simulation);

  /// Writes the last state to frames and tables, and the end into the manifest. `reason`: why the
  /// run ended.
  void finish(Simulation const& simulation, std::string const& reason, double wall_time);

  /// Writes the end of a run that broke down into the manifest, and its particles apart from the
  /// good frames, with culprits flagged (bad_frame.hpp). Returns the path of that frame.
  std::filesystem::path give_up(Simulation const& simulation, std::string const& reason,
                                std::vector<Flag> const& flags, double wall_time);

  /// Writes the particles as they are to `snapshots/`, and the walls where they move: a frame that
  /// somebody asked for, apart from those of the case. Returns its path.
  std::filesystem::path write_snapshot(Simulation const& simulation) const;

  /// Who has limited the time steps so far.
  VoteTally const& votes() const { return votes_; }

  /// Call when a stage has begun and its first rates are there (Simulation::on_new_rates).
  void tell_new_rates(Simulation const& simulation) { probes_.tell_new_rates(simulation); }

  /// Time [s] since the run was started, without that in which it was stopped.
  double wall_time() const;

  /// Time spent on writing, by label.
  Timers const& timers() const { return timers_; }

  /// What the gauges have to say at the end; one line each.
  std::vector<std::string> remarks() const { return probes_.remarks(); }

 private:
  void write_start(int threads);
  void pass_schedules(double time);
  void tell_probes(Simulation const& simulation);
  void write_end(Simulation const& simulation, std::string const& reason, double wall_time);
  void write_stages(Simulation const& simulation);
  void write_frame(Simulation const& simulation);
  void write_gauges(Simulation const& simulation);
  void write_sums(Simulation const& simulation);

  Case case_;
  std::filesystem::path folder_;
  Manifest manifest_;
  PvdCollection frames_;
  PvdCollection wall_frames_;  // where walls move
  PlaneRecorder planes_;
  ProbeRecorder probes_;
  TableCsv gauges_;
  TableCsv sums_;
  Schedule frame_schedule_, gauge_schedule_, sums_schedule_;
  VoteTally votes_;
  Timers timers_;
  int frame_timer_ = timers_.add("write frames");
  int gauge_timer_ = timers_.add("gauges");
  int sums_timer_ = timers_.add("sums");
  std::size_t synced_frames_ = 0;
  double earlier_wall_time_ = 0.0;  // s, of the parts before it was resumed
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  double last_gauge_time_ = -1.0;
  double last_sums_time_ = -1.0;
};

}  // namespace moraine
