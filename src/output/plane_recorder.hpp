// The planes of a run: fields on grids, written with the frames.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "output/pvd_collection.hpp"
#include "probes/grid_probe.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// Writes planes/NAME_000000.vti ... and planes/NAME.pvd for each gauge of kind plane.
class PlaneRecorder {
 public:
  /// `frame_times` [s]: of the frames that are there already; what was written later is gone by
  /// then (drop_planes).
  PlaneRecorder(Case const& c, std::filesystem::path folder,
                std::vector<double> const& frame_times = {});

  /// Writes the collections as they are.
  void write_collections() const;

  /// Call with each frame.
  void write(Simulation const& simulation);

  /// Hands what has been written since to the disk.
  void sync();

 private:
  struct Plane {
    std::string name;
    PlaceGrid grid;
    PvdCollection files;
  };
  std::filesystem::path folder_;
  std::vector<Plane> planes_;
  std::size_t synced_ = 0;  // frames
};

}  // namespace moraine
