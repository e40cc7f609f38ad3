#include "verify/gauge_table.hpp"

#include <stdexcept>
#include <string>

#include "output/probe_recorder.hpp"
#include "output/run_recorder.hpp"

namespace moraine {

Table read_gauges(Simulation& simulation, Case const& c) {
  ProbeRecorder probes(c);
  Schedule schedule(c.output.gauge_interval, {}, c.output.gauge_interval <= 0.0);
  Table table{probes.columns(), {}};
  table.values.resize(table.columns.size());
  auto const read_when_due = [&] {
    probes.tell(simulation);
    if (!schedule.due(simulation.time()) && simulation.running()) return;
    std::vector<double> const row = probes.read(simulation);
    for (std::size_t k = 0; k < row.size(); ++k) table.values[k].push_back(row[k]);
  };
  read_when_due();
  while (simulation.running()) {
    simulation.advance();
    read_when_due();
  }
  return table;
}

std::vector<double> const& column(Table const& table, std::string_view name) {
  std::vector<double> const* const found = table.find(name);
  if (found == nullptr) throw std::invalid_argument("no column " + std::string(name));
  return *found;
}

}  // namespace moraine
