#include "output/plane_recorder.hpp"

#include <fmt/format.h>

#include <charconv>
#include <regex>
#include <utility>

#include "output/atomic_file.hpp"
#include "output/vti_writer.hpp"

namespace moraine {
namespace {

std::string file_name(std::string const& plane, std::size_t number) {
  return fmt::format("{}_{:06}.vti", plane, number);
}

}  // namespace

PlaneRecorder::PlaneRecorder(Case const& c, std::filesystem::path folder,
                             std::vector<double> const& frame_times)
    : folder_(std::move(folder) / "planes"), synced_(frame_times.size()) {
  for (GaugeSpec const& gauge : c.gauges) {
    if (gauge.kind != GaugeKind::plane) continue;
    std::vector<PvdEntry> entries;
    for (double const time : frame_times)
      entries.push_back({time, file_name(gauge.name, entries.size())});
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
    std::string const name = file_name(plane.name, plane.files.entries().size());
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
    for (Plane const& plane : planes_) sync_to_disk(folder_ / file_name(plane.name, synced_));
  sync_to_disk(folder_);
}

void drop_planes(std::filesystem::path const& folder, std::size_t first) {
  static std::regex const ours("[A-Za-z0-9_-]+_([0-9]{6,})\\.vti");
  static std::regex const collections("[A-Za-z0-9_-]+\\.pvd");
  remove_files(folder / "planes", [&](std::string const& name) {
    std::smatch match;
    if (!std::regex_match(name, match, ours))
      return first == 0 && std::regex_match(name, collections);
    std::string const digits = match[1];
    std::size_t number = 0;
    auto const end = digits.data() + digits.size();
    auto const [ignored, error] = std::from_chars(digits.data(), end, number);
    return error == std::errc{} && number >= first;
  });
}

}  // namespace moraine
