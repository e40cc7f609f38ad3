#include "output/probe_recorder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "output/atomic_file.hpp"
#include "probes/decay_fit.hpp"

namespace moraine {
namespace {

bool reads(Case const& c, GaugeKind kind) {
  return std::any_of(c.gauges.begin(), c.gauges.end(),
                     [kind](GaugeSpec const& gauge) { return gauge.kind == kind; });
}

/// JSON has no number for what is none.
nlohmann::ordered_json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

bool is_pressure(TableColumn const& column) { return column.unit == "Pa"; }

nlohmann::ordered_json summary_of(TableColumn const& column, ReadingSummary const& summary,
                                  bool with_arrival) {
  nlohmann::ordered_json json{{"unit", column.unit},
                              {"first", number_or_null(summary.first())},
                              {"largest", number_or_null(summary.largest())},
                              {"time_of_largest", number_or_null(summary.time_of_largest())},
                              {"smallest", number_or_null(summary.smallest())},
                              {"time_of_smallest", number_or_null(summary.time_of_smallest())},
                              {"integral_over_time", number_or_null(summary.integral())}};
  if (is_pressure(column)) json["impulse"] = number_or_null(summary.rise_integral());
  if (is_pressure(column) && with_arrival) {
    json["arrival"] = number_or_null(summary.arrival());
    json["duration"] = number_or_null(summary.duration());
  }
  return json;
}

/// Of the largest rises of the columns, given by the first summary of the gauge.
nlohmann::ordered_json decay_of(Decay const& decay, ReadingSummary const* summaries) {
  std::vector<double> rises;
  for (std::size_t const column : decay.columns)
    rises.push_back(summaries[column].largest() - summaries[column].first());
  DecayFit const fit = fit_decay(decay.distances, rises);
  return {{"exponent", number_or_null(fit.exponent)},
          {"points", fit.points},
          {"scatter", number_or_null(fit.scatter)}};
}

}  // namespace

ProbeRecorder::ProbeRecorder(Case const& c)
    : columns_{{"time", "s"}},
      rise_(c.output.arrival_pressure),
      reads_walls_(reads(c, GaugeKind::wall)),
      reads_budget_(reads(c, GaugeKind::budget)) {
  for (GaugeSpec const& gauge : c.gauges) {
    readers_.push_back(make_gauge_reader(c, gauge));
    auto const& columns = readers_.back().columns;
    columns_.insert(columns_.end(), columns.begin(), columns.end());
  }
  summaries_.resize(columns_.size() - 1);
  seen_.resize(readers_.size(), 0);
  if (!rise_) return;
  envelope_.emplace(*rise_);
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < c.gauges.size(); ++k) {
    GaugeKind const kind = c.gauges[k].kind;
    if (kind != GaugeKind::point && kind != GaugeKind::particle) continue;
    placed_.push_back(k);
    places.push_back(c.gauges[k].position);
  }
  if (!placed_.empty() && !c.walls.empty()) reflections_.emplace(*rise_, std::move(places));
  for (auto& summary : summaries_) summary.set_rise(*rise_);
}

void ProbeRecorder::tell(Simulation const& simulation) {
  if (reads_budget_) budget_.tell(simulation);
  if (envelope_) envelope_->tell(simulation.particles(), simulation.time());
  if (reflections_) reflections_->tell(simulation.model(), simulation.time());
}

void ProbeRecorder::tell_new_rates(Simulation const& simulation) {
  if (reads_budget_) budget_.tell_new_rates(simulation);
}

std::vector<double> ProbeRecorder::read(Simulation const& simulation) {
  // A restored run has no pairs before its first step.
  loads_.clear();
  bool const known = reads_walls_ && simulation.pairs().bytes() > 0;
  if (known) {
    simulation.loads_on_walls(loads_);
    simulation.loads_on_mirrors(mirror_loads_);
  }
  ReadingContext const at{simulation, loads_, mirror_loads_, budget_, known};
  std::vector<double> row{simulation.time()};
  for (std::size_t k = 0; k < readers_.size(); ++k)
    if (readers_[k].read(at, row)) seen_[k] = 1;
  for (std::size_t k = 0; k < summaries_.size(); ++k)
    summaries_[k].add(simulation.time(), row[k + 1]);
  return row;
}

std::vector<ParticleArray> ProbeRecorder::envelopes() const {
  if (!envelope_) return {};
  return {{"peak_pressure", "Pa", envelope_->peak()},
          {"time_of_peak", "s", envelope_->time_of_peak()},
          {"arrival", "s", envelope_->arrival()},
          {"impulse", "Pa s", envelope_->impulse()}};
}

std::vector<std::string> ProbeRecorder::remarks() const {
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < readers_.size(); ++k)
    if (seen_[k] == 0)
      lines.push_back(fmt::format("gauge \"{}\" has seen nothing", readers_[k].name));
  for (std::size_t n = 0; reflections_ && n < placed_.size(); ++n)
    if (double const from = reflections_->earliest()[n]; std::isfinite(from))
      lines.push_back(
          fmt::format("gauge \"{}\": from {:.4g} s on it may read what a wall has reflected",
                      readers_[placed_[n]].name, from));
  return lines;
}

void ProbeRecorder::write_summary(std::filesystem::path const& path) const {
  auto gauges = nlohmann::ordered_json::array();
  std::size_t column = 0;
  for (std::size_t k = 0; k < readers_.size(); ++k) {
    auto quantities = nlohmann::ordered_json::object();
    std::size_t const first = column;
    for (TableColumn const& heading : readers_[k].columns)
      quantities[heading.name] = summary_of(heading, summaries_[column++], rise_.has_value());
    gauges.push_back(
        {{"name", readers_[k].name}, {"seen", seen_[k] != 0}, {"columns", quantities}});
    if (readers_[k].decay)
      gauges.back()["decay"] = decay_of(*readers_[k].decay, summaries_.data() + first);
  }
  for (std::size_t n = 0; reflections_ && n < placed_.size(); ++n)
    gauges[placed_[n]]["reflected_from"] = number_or_null(reflections_->earliest()[n]);
  AtomicFile file(path);
  file.stream() << nlohmann::ordered_json{{"gauges", gauges}}.dump(2) << '\n';
  file.commit();
}

void ProbeRecorder::exchange(Archive& archive) {
  std::size_t const gauges = seen_.size();
  archive.array("gauges/seen", "", seen_);
  if (seen_.size() != gauges)
    throw std::runtime_error("the saved state does not belong to the gauges of this case");
  for (std::size_t k = 0; k < summaries_.size(); ++k)
    summaries_[k].exchange(archive, fmt::format("gauges/column_{}", k + 1));
  for (std::size_t k = 0; k < readers_.size(); ++k)
    if (readers_[k].memory)
      archive.array(fmt::format("gauges/memory_{}", k + 1), "", *readers_[k].memory);
  if (reads_budget_) budget_.exchange(archive);
  if (envelope_) envelope_->exchange(archive);
  if (reflections_) reflections_->exchange(archive);
}

}  // namespace moraine
