#include "output/plane_recorder.hpp"

#include <utility>

#include "output/atomic_file.hpp"
#include "output/plane_files.hpp"
#include "output/vti_writer.hpp"

namespace moraine {
PlaneRecorder::PlaneRecorder(Case const& c, std::filesystem::path folder,
                             std::vector<double> const& frame_times)
    : folder_(std::move(folder) / "planes"), synced_(frame_times.size()) {
  for (GaugeSpec const& gauge : c.gauges) {
    if (gauge.kind != GaugeKind::plane) continue;
    std::vector<PvdEntry> entries;
    for (double const time : frame_times)
      entries.push_back({time, plane_file(gauge.name, entries.size())});
    auto const& [min, max, step] = gauge.probe.plane;
    planes_.push_back({gauge.name, grid_between(min, max, step),
                       PvdCollection(folder_ / (gauge.name + ".pvd"), std::move(entries))});
  }
}

void PlaneRecorder::write_collections() const {
  for (Plane const& plane : planes_) plane.files.write();
}

void PlaneRecorder::write(Simulation const& simulation) {
  Numerics const& numerics = simulation.model().numerics;
  for (Plane& plane : planes_) {
    std::string const name = plane_file(plane.name, plane.files.entries().size());
    write_vti(folder_ / name, plane.grid,
              probe_grid(simulation.particles(), simulation.search(), numerics.kernel,
                         numerics.smoothing_length(), plane.grid),
              simulation.time());
    plane.files.add(simulation.time(), name);
  }
}

void PlaneRecorder::sync() {
  if (planes_.empty()) return;
  std::size_t const count = planes_.front().files.entries().size();
  for (; synced_ < count; ++synced_)
    for (Plane const& plane : planes_) sync_to_disk(folder_ / plane_file(plane.name, synced_));
  sync_to_disk(folder_);
}

}  // namespace moraine
