#include "output/run_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/atomic_file.hpp"
#include "output/run_folder.hpp"
#include "output/vtp_writer.hpp"
#include "probes/point_probe.hpp"
#include "setup/used_case.hpp"

namespace moraine {
namespace {

constexpr std::array axis_letter{'x', 'y', 'z'};

std::vector<TableColumn> gauge_columns(Case const& c) {
  std::vector<TableColumn> columns{{"time", "s"}};
  for (GaugeSpec const& gauge : c.gauges) {
    if (gauge.kind == GaugeKind::front) {
      columns.push_back({gauge.name + " front", "m"});
      continue;
    }
    columns.push_back({gauge.name + " pressure", "Pa"});
    columns.push_back({gauge.name + " density", "kg/m^3"});
    columns.push_back({gauge.name + " specific_energy", "J/kg"});
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
      columns.push_back({fmt::format("{} velocity_{}", gauge.name, axis_letter[axis]), "m/s"});
  }
  return columns;
}

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
          {"mass", "kg"},
          {"particles", ""},
          {"lost_particles", ""},
          {"time_step", "s"}};
}

MaterialId material_of(Case const& c, std::string const& name) {
  auto const found = std::find_if(c.materials.begin(), c.materials.end(),
                                  [&](MaterialSpec const& m) { return m.name == name; });
  return static_cast<MaterialId>(found - c.materials.begin());
}

std::vector<PvdEntry> frames_at(std::vector<double> const& times) {
  std::vector<PvdEntry> frames;
  for (double const time : times) frames.push_back({time, frame_name(frames.size())});
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
    : case_(c),
      folder_(std::move(folder)),
      frames_(folder_ / "particles.pvd"),
      gauges_(folder_ / "gauges.csv", gauge_columns(c)),
      sums_(folder_ / "sums.csv", sums_columns()),
      frame_schedule_(c.output.frame_interval, c.output.frame_times, false),
      gauge_schedule_(c.output.gauge_interval, {}, c.output.gauge_interval <= 0.0),
      sums_schedule_(c.output.sums_interval, {}, c.output.sums_interval <= 0.0) {
  AtomicFile used(folder_ / "case.used.toml");
  used.stream() << used_case(c);
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
    std::filesystem::remove(folder_ / "walls.vtp");
  pass_schedules(0.0);
  write_frame(simulation);
  write_gauges(simulation);
  write_sums(simulation);
}

RunRecorder::RunRecorder(Case const& c, Simulation const& simulation, std::filesystem::path folder,
                         int threads, RecorderState const& saved)
    : case_(c),
      folder_(std::move(folder)),
      manifest_(saved.manifest),
      frames_(folder_ / "particles.pvd", frames_at(saved.frame_times)),
      gauges_(folder_ / "gauges.csv", gauge_columns(c), saved.gauges_size),
      sums_(folder_ / "sums.csv", sums_columns(), saved.sums_size),
      frame_schedule_(c.output.frame_interval, c.output.frame_times, false),
      gauge_schedule_(c.output.gauge_interval, {}, c.output.gauge_interval <= 0.0),
      sums_schedule_(c.output.sums_interval, {}, c.output.sums_interval <= 0.0),
      synced_frames_(saved.frame_times.size()),
      last_gauge_time_(saved.last_gauge_time),
      last_sums_time_(saved.last_sums_time) {
  drop_frames(folder_, saved.frame_times.size());
  frames_.write();
  manifest_.resumed_at_steps.push_back(simulation.step());
  manifest_.stages = simulation.stage_events();
  write_start(threads);
  pass_schedules(simulation.time());
}

void RunRecorder::write_start(int threads) {
  manifest_.build = build_info();
  manifest_.threads = threads;
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
  return state;
}

void RunRecorder::sync() {
  for (TableCsv const* table : {&gauges_, &sums_}) sync_to_disk(table->path());
  for (; synced_frames_ < frames_.entries().size(); ++synced_frames_)
    sync_to_disk(folder_ / frame_name(synced_frames_));
}

void RecorderState::exchange(Archive& archive) {
  archive.array("output/frame_times", "s", frame_times);
  archive.number("output/gauges_size", gauges_size);
  archive.number("output/sums_size", sums_size);
  archive.number("output/last_gauge_time", last_gauge_time);
  archive.number("output/last_sums_time", last_sums_time);
  archive.text("output/case_file", manifest.case_file);
  archive.text("output/case_sha256", manifest.case_sha256);
  archive.text("output/start_time", manifest.start_time);
  archive.number("output/particles_at_start", manifest.particles);
  archive.array("output/resumed_at_steps", "", manifest.resumed_at_steps);
}

void RunRecorder::tell(Simulation const& simulation) {
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
                                           double wall_time) {
  auto const snapshot = folder_ / "unstable.vtp";
  write_vtp(snapshot, simulation.particles(), Kind::fluid, simulation.time());
  write_end(simulation, reason, wall_time);
  return snapshot;
}

void RunRecorder::write_end(Simulation const& simulation, std::string const& reason,
                            double wall_time) {
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
  std::string const name = frame_name(frames_.entries().size());
  write_vtp(folder_ / name, simulation.particles(), Kind::fluid, simulation.time());
  frames_.add(simulation.time(), name);
}

void RunRecorder::write_gauges(Simulation const& simulation) {
  ScopedTimer const timing(timers_, gauge_timer_);
  last_gauge_time_ = simulation.time();
  std::vector<double> row{simulation.time()};
  for (GaugeSpec const& gauge : case_.gauges) {
    if (gauge.kind == GaugeKind::front) {
      row.push_back(probe_front(simulation.particles(), material_of(case_, gauge.material),
                                gauge.axis, gauge.direction));
      continue;
    }
    PointState const state =
        probe_point(simulation.particles(), simulation.search(), case_.numerics.kernel,
                    case_.numerics.smoothing_length(), gauge.position);
    row.insert(row.end(), {state.pressure, state.density, state.specific_energy});
    row.insert(row.end(), state.velocity.begin(), state.velocity.begin() + case_.dimension);
  }
  gauges_.add(row);
}

void RunRecorder::write_sums(Simulation const& simulation) {
  ScopedTimer const timing(timers_, sums_timer_);
  last_sums_time_ = simulation.time();
  ConservedSums const s = simulation.sums();
  std::array const row{simulation.time(),
                       s.kinetic_energy,
                       s.internal_energy,
                       s.potential_energy,
                       s.total_energy(),
                       s.momentum[0],
                       s.momentum[1],
                       s.momentum[2],
                       s.wall_impulse[0],
                       s.wall_impulse[1],
                       s.wall_impulse[2],
                       s.mass,
                       static_cast<double>(simulation.particles().range(Kind::fluid).size()),
                       static_cast<double>(simulation.lost().count),
                       simulation.time_step()};
  sums_.add(row);
}

}  // namespace moraine
