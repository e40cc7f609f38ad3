// How each kind of gauge is read: its columns, and its values at one time.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "output/energy_budget.hpp"
#include "output/table_csv.hpp"
#include "probes/wall_probe.hpp"
#include "setup/case.hpp"
#include "step/simulation.hpp"

namespace moraine {

/// A run at the moment of a reading, with what several gauges share.
struct ReadingContext {
  Simulation const& simulation;
  // Of the wet walls. Not known where no gauge reads a wall, or where a run was restored and has
  // made no step since: then their readings are no numbers.
  std::vector<WallLoad> const& loads;
  std::vector<MirrorLoad> const& mirror_loads;  // the same of mirror walls
  EnergyBudget const& budget;
  bool loads_known = false;
};

/// Columns of pressure whose peaks belong to distances, for a power law.
struct Decay {
  std::vector<double> distances;     // m
  std::vector<std::size_t> columns;  // of the gauge
};

/// One gauge. `read` appends one value per column and returns whether the gauge saw anything: a
/// particle, a wet wall, a surface.
struct GaugeReader {
  std::string name;
  std::vector<TableColumn> columns;
  std::function<bool(ReadingContext const&, std::vector<double>&)> read;
  /// What `read` remembers from reading to reading, if anything: a checkpoint keeps it.
  std::shared_ptr<std::vector<double>> memory{};
  std::optional<Decay> decay{};
};

/// The reader of a gauge of this case, whose names are known to be good.
GaugeReader make_gauge_reader(Case const& c, GaugeSpec const& gauge);

}  // namespace moraine
