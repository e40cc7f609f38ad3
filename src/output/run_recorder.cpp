#include "output/run_recorder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "output/atomic_file.hpp"
#include "output/bad_frame.hpp"
#include "output/kept_files.hpp"
#include "output/run_folder.hpp"
#include "output/vtp_writer.hpp"
#include "setup/used_case.hpp"

namespace moraine {
std::vector<TableColumn> sums_columns() {
  return {{"time", "s"},
          {"kinetic_energy", "J"},
          {"internal_energy", "J"},
          {"potential_energy", "J"},
          {"total_energy", "J"},
          {"momentum_x", "kg m/s"},
          {"momentum_y", "kg m/s"},
          {"momentum_z", "kg m/s"},
          {"wall_impulse_x", "N s"},
          {"wall_impulse_y", "N s"},
          {"wall_impulse_z", "N s"},
          {"wall_work", "J"},
          {"mass", "kg"},
          {"particles", ""},
          {"lost_particles", ""},
          {"time_step", "s"},
          {"lost_energy", "J"},
          {"damping_work", "J"},
          {"detonation_energy", "J"},
          {"penalty_energy", "J"},
          {"drift_work", "J"}};
}

namespace {

template <class Name>
std::vector<PvdEntry> frames_at(std::vector<double> const& times, Name&& name) {
  std::vector<PvdEntry> frames;
  for (double const time : times) frames.push_back({time, name(frames.size())});
  return frames;
}

}  // namespace

Schedule::Schedule(double interval, std::vector<double> times, bool every_step)
    : interval_(interval), times_(std::move(times)), every_step_(every_step) {
  std::sort(times_.begin(), times_.end());
}

bool Schedule::due(double time) {
  bool due = every_step_;
  // A step may end a rounding error before the time it was meant for.
  double const now = time * (1.0 + 1e-12);
  if (interval_ > 0.0 && now >= next_) {
    due = true;
    next_ = interval_ * (std::floor(now / interval_) + 1.0);
  }
  for (; next_listed_ < times_.size() && now >= times_[next_listed_]; ++next_listed_) due = true;
  return due;
}

RunRecorder::RunRecorder(Case const& c, Simulation const& simulation, std::filesystem::path folder,
                         int threads)
    : case_(with_kept_files(c, folder)),
      folder_(std::move(folder)),
      frames_(folder_ / "particles.pvd"),
      wall_frames_(folder_ / "walls.pvd"),
      planes_(c, folder_),
      probes_(c),
      gauges_(folder_ / "gauges.csv", probes_.columns()),
      sums_(folder_ / "sums.csv", sums_columns()),
      frame_schedule_(c.output.frame_interval, c.output.frame_times, false),
      gauge_schedule_(c.output.gauge_interval, {}, c.output.gauge_interval <= 0.0),
      sums_schedule_(c.output.sums_interval, {}, c.output.sums_interval <= 0.0) {
  AtomicFile used(folder_ / "case.used.toml");
  used.stream() << used_case(case_);
  used.commit();
  manifest_.case_file = c.file;
  manifest_.case_sha256 = file_sha256(c.file);
  manifest_.start_time = utc_now();
  manifest_.particles = simulation.particles().size();
  manifest_.stages = simulation.stage_events();
  write_start(threads);
  if (simulation.particles().range(Kind::wall).size() > 0)
    write_vtp(folder_ / "walls.vtp", simulation.particles(), Kind::wall, 0.0);
  else
    remove_file(folder_ / "walls.vtp");
  tell_probes(simulation);
  pass_schedules(0.0);
  write_frame(simulation);
  write_gauges(simulation);
  write_sums(simulation);
}

RunRecorder::RunRecorder(Case const& c, Simulation const& simulation, std::filesystem::path folder,
                         int threads, RecorderState const& saved)
    : case_(with_kept_files(c, folder)),
      folder_(std::move(folder)),
      manifest_(saved.manifest),
      frames_(folder_ / "particles.pvd", frames_at(saved.frame_times, frame_name)),
      wall_frames_(folder_ / "walls.pvd", frames_at(saved.frame_times, wall_frame_name)),
      planes_(c, folder_, saved.frame_times),
      probes_(c),
      gauges_(folder_ / "gauges.csv", probes_.columns(), saved.gauges_size),
      sums_(folder_ / "sums.csv", sums_columns(), saved.sums_size),
      frame_schedule_(c.output.frame_interval, c.output.frame_times, false),
      gauge_schedule_(c.output.gauge_interval, {}, c.output.gauge_interval <= 0.0),
      sums_schedule_(c.output.sums_interval, {}, c.output.sums_interval <= 0.0),
      synced_frames_(saved.frame_times.size()),
      earlier_wall_time_(saved.wall_time),
      last_gauge_time_(saved.last_gauge_time),
      last_sums_time_(saved.last_sums_time) {
  drop_frames(folder_, saved.frame_times.size());
  frames_.write();
  if (simulation.model().walls.move()) wall_frames_.write();
  planes_.write_collections();
  manifest_.resumed_at_steps.push_back(simulation.step());
  manifest_.stages = simulation.stage_events();
  write_start(threads);
  pass_schedules(simulation.time());
}

void RunRecorder::write_start(int threads) {
  manifest_.build = build_info();
  manifest_.threads = threads;
  if (StartInfo const& from = case_.start.info; !case_.start.run.empty())
    manifest_.start = RunStart{from.run, from.checkpoint, from.sha256, from.time, from.step};
  manifest_.precision = case_.numerics.precision == Precision::mixed ? "mixed" : "double";
  write_manifest(folder_ / "manifest.json", manifest_);
}

/// What is due at a time has been written. So what a schedule knows is a function of time alone.
void RunRecorder::pass_schedules(double time) {
  for (Schedule* schedule : {&frame_schedule_, &gauge_schedule_, &sums_schedule_})
    schedule->due(time);
}

RecorderState RunRecorder::state() const {
  RecorderState state;
  state.manifest = manifest_;
  for (PvdEntry const& frame : frames_.entries()) state.frame_times.push_back(frame.time);
  state.gauges_size = gauges_.size();
  state.sums_size = sums_.size();
  state.last_gauge_time = last_gauge_time_;
  state.last_sums_time = last_sums_time_;
  state.wall_time = wall_time();
  return state;
}

void RunRecorder::sync() {
  for (TableCsv const* table : {&gauges_, &sums_}) sync_to_disk(table->path());
  for (; synced_frames_ < frames_.entries().size(); ++synced_frames_) {
    sync_to_disk(folder_ / frame_name(synced_frames_));
    if (synced_frames_ < wall_frames_.entries().size())
      sync_to_disk(folder_ / wall_frame_name(synced_frames_));
  }
  planes_.sync();
  for (auto const& folder : {folder_ / "frames", folder_}) sync_to_disk(folder);
}

void RecorderState::exchange(Archive& archive) {
  archive.array("output/frame_times", "s", frame_times);
  archive.number("output/gauges_size", gauges_size);
  archive.number("output/sums_size", sums_size);
  archive.number("output/last_gauge_time", last_gauge_time);
  archive.number("output/last_sums_time", last_sums_time);
  archive.number("output/wall_time", wall_time);
  archive.text("output/case_file", manifest.case_file);
  archive.text("output/case_sha256", manifest.case_sha256);
  archive.text("output/start_time", manifest.start_time);
  archive.number("output/particles_at_start", manifest.particles);
  archive.array("output/resumed_at_steps", "", manifest.resumed_at_steps);
}

double RunRecorder::wall_time() const {
  std::chrono::duration<double> const now = std::chrono::steady_clock::now() - begun_;
  return earlier_wall_time_ + now.count();
}

void RunRecorder::exchange_memory(Archive& archive) {
  probes_.exchange(archive);
  votes_.exchange(archive);
}

void RunRecorder::tell(Simulation const& simulation) {
  votes_.note(simulation.vote());
  tell_probes(simulation);
  double const time = simulation.time();
  if (simulation.stage_events().size() > manifest_.stages.size()) write_stages(simulation);
  if (frame_schedule_.due(time)) write_frame(simulation);
  if (gauge_schedule_.due(time)) write_gauges(simulation);
  if (sums_schedule_.due(time)) write_sums(simulation);
}

void RunRecorder::finish(Simulation const& simulation, std::string const& reason,
                         double wall_time) {
  double const time = simulation.time();
  if (time > frames_.entries().back().time) write_frame(simulation);
  if (time > last_gauge_time_) write_gauges(simulation);
  if (time > last_sums_time_) write_sums(simulation);
  write_end(simulation, reason, wall_time);
}

std::filesystem::path RunRecorder::give_up(Simulation const& simulation, std::string const& reason,
                                           std::vector<Flag> const& flags, double wall_time) {
  auto const frame = write_bad_frame(folder_, simulation, flags);
  write_end(simulation, reason, wall_time);
  return frame;
}

std::filesystem::path RunRecorder::write_snapshot(Simulation const& simulation) const {
  auto const file = folder_ / snapshot_name(simulation.step());
  write_vtp(file, simulation.particles(), Kind::fluid, simulation.time(), probes_.envelopes());
  if (simulation.model().walls.move())
    write_vtp(folder_ / wall_snapshot_name(simulation.step()), simulation.particles(), Kind::wall,
              simulation.time());
  return file;
}

void RunRecorder::tell_probes(Simulation const& simulation) {
  if (!probes_.follows_steps()) return;
  ScopedTimer const timing(timers_, gauge_timer_);
  probes_.tell(simulation);
}

void RunRecorder::write_end(Simulation const& simulation, std::string const& reason,
                            double wall_time) {
  probes_.write_summary(folder_ / "gauges.json");
  manifest_.end = RunEnd{reason, wall_time, simulation.time(), simulation.step(),
                         simulation.particles().size()};
  write_manifest(folder_ / "manifest.json", manifest_);
}

void RunRecorder::write_stages(Simulation const& simulation) {
  manifest_.stages = simulation.stage_events();
  write_manifest(folder_ / "manifest.json", manifest_);
}

void RunRecorder::write_frame(Simulation const& simulation) {
  ScopedTimer const timing(timers_, frame_timer_);
  std::size_t const number = frames_.entries().size();
  if (simulation.model().walls.move()) {
    write_vtp(folder_ / wall_frame_name(number), simulation.particles(), Kind::wall,
              simulation.time());
    wall_frames_.add(simulation.time(), wall_frame_name(number));
  }
  std::string const name = frame_name(number);
  write_vtp(folder_ / name, simulation.particles(), Kind::fluid, simulation.time(),
            probes_.envelopes());
  planes_.write(simulation);
  frames_.add(simulation.time(), name);
}

void RunRecorder::write_gauges(Simulation const& simulation) {
  ScopedTimer const timing(timers_, gauge_timer_);
  last_gauge_time_ = simulation.time();
  gauges_.add(probes_.read(simulation));
}

void RunRecorder::write_sums(Simulation const& simulation) {
  ScopedTimer const timing(timers_, sums_timer_);
  last_sums_time_ = simulation.time();
  ConservedSums const s = simulation.sums();
  Symmetry const& planes = simulation.model().symmetry;
  Vec3 const momentum = planes.whole(s.momentum);
  Vec3 const impulse = planes.whole(s.wall_impulse);
  std::array const row{simulation.time(),
                       planes.whole(s.kinetic_energy),
                       planes.whole(s.internal_energy),
                       planes.whole(s.potential_energy),
                       planes.whole(s.total_energy()),
                       momentum[0],
                       momentum[1],
                       momentum[2],
                       impulse[0],
                       impulse[1],
                       impulse[2],
                       planes.whole(simulation.booked().walls),
                       planes.whole(s.mass),
                       static_cast<double>(simulation.particles().range(Kind::fluid).size()),
                       static_cast<double>(simulation.lost().count),
                       simulation.time_step(),
                       planes.whole(simulation.lost().energy),
                       planes.whole(simulation.booked().damping),
                       planes.whole(simulation.booked().detonation),
                       planes.whole(s.penalty_energy),
                       planes.whole(simulation.booked().drift)};
  sums_.add(row);
}

}  // namespace moraine
