#include "output/run_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "output/atomic_file.hpp"
#include "output/plot/plot.hpp"
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

bool is_frame(std::string const& file_name) {
  static std::regex const pattern("particles_[0-9]{6,}\\.vtp");
  return std::regex_match(file_name, pattern);
}

/// The folder, without the frames, the pictures and the snapshot that an earlier run left in it;
/// other files stay.
std::filesystem::path prepared(std::filesystem::path folder) {
  std::filesystem::create_directories(folder / "frames");
  std::vector<std::filesystem::path> old{folder / "unstable.vtp"};
  auto const collect = [&](std::filesystem::path const& place, auto const& ours) {
    if (!std::filesystem::is_directory(place)) return;
    for (auto const& entry : std::filesystem::directory_iterator(place))
      if (ours(entry.path().filename().string())) old.push_back(entry.path());
  };
  collect(folder / "frames", is_frame);
  collect(folder / "plots", is_picture_of_run);
  for (auto const& file : old) std::filesystem::remove(file);
  return folder;
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
      folder_(prepared(std::move(folder))),
      frames_(folder_ / "particles.pvd"),
      gauges_(folder_ / "gauges.csv", gauge_columns(c)),
      sums_(folder_ / "sums.csv", sums_columns()),
      frame_schedule_(c.output.frame_interval, c.output.frame_times, false),
      gauge_schedule_(c.output.gauge_interval, {}, c.output.gauge_interval <= 0.0),
      sums_schedule_(c.output.sums_interval, {}, c.output.sums_interval <= 0.0) {
  AtomicFile used(folder_ / "case.used.toml");
  used.stream() << used_case(c);
  used.commit();
  manifest_.build = build_info();
  manifest_.threads = threads;
  manifest_.precision = c.numerics.precision == Precision::mixed ? "mixed" : "double";
  manifest_.case_file = c.file;
  manifest_.case_sha256 = file_sha256(c.file);
  manifest_.start_time = utc_now();
  manifest_.particles = simulation.particles().size();
  write_manifest(folder_ / "manifest.json", manifest_);
  if (simulation.particles().range(Kind::wall).size() > 0)
    write_vtp(folder_ / "walls.vtp", simulation.particles(), Kind::wall, 0.0);
  else
    std::filesystem::remove(folder_ / "walls.vtp");
  frame_schedule_.due(0.0);
  write_frame(simulation);
  gauge_schedule_.due(0.0);
  write_gauges(simulation);
  sums_schedule_.due(0.0);
  write_sums(simulation);
}

void RunRecorder::tell(Simulation const& simulation) {
  double const time = simulation.time();
  if (frame_schedule_.due(time)) write_frame(simulation);
  if (gauge_schedule_.due(time)) write_gauges(simulation);
  if (sums_schedule_.due(time)) write_sums(simulation);
}

void RunRecorder::finish(Simulation const& simulation, std::string const& reason,
                         double wall_time) {
  double const time = simulation.time();
  if (time > last_frame_time_) write_frame(simulation);
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

void RunRecorder::write_frame(Simulation const& simulation) {
  ScopedTimer const timing(timers_, frame_timer_);
  std::string const name = fmt::format("frames/particles_{:06}.vtp", frame_count_++);
  write_vtp(folder_ / name, simulation.particles(), Kind::fluid, simulation.time());
  frames_.add(simulation.time(), name);
  last_frame_time_ = simulation.time();
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
