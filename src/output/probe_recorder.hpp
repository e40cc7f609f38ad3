// All gauges of a run: their readings, what is left of them at the end, and the envelopes of
// particles.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "output/gauge_reader.hpp"
#include "output/reflection_clock.hpp"
#include "output/vtp_writer.hpp"
#include "probes/envelope.hpp"
#include "probes/reading_summary.hpp"

namespace moraine {

/// Reads the gauges of a case and keeps what must be remembered from reading to reading and from
/// step to step. Its state travels with a checkpoint through `exchange`.
class ProbeRecorder {
 public:
  explicit ProbeRecorder(Case const& c);

  /// Columns of the table of readings: time first.
  std::vector<TableColumn> const& columns() const { return columns_; }

  /// Whether something is followed from step to step: the energy budget, envelopes.
  bool follows_steps() const { return reads_budget_ || envelope_.has_value(); }

  /// Call at the start and after each step, before reading.
  void tell(Simulation const& simulation);

  /// Call when a stage has begun and its first rates are there.
  void tell_new_rates(Simulation const& simulation);

  /// A row of readings. Readings of one time must be taken once: they enter the summary.
  std::vector<double> read(Simulation const& simulation);

  /// Envelopes to write with a frame; none where the case asks for none.
  std::vector<ParticleArray> envelopes() const;

  /// One line for each gauge that has never seen anything, or that walls may have reflected to.
  std::vector<std::string> remarks() const;

  /// Writes extremes, integrals and arrivals of all columns as JSON.
  void write_summary(std::filesystem::path const& path) const;

  void exchange(Archive& archive);

 private:
  std::vector<GaugeReader> readers_;
  std::vector<TableColumn> columns_;
  std::vector<ReadingSummary> summaries_;  // of all columns but the time
  std::vector<std::uint8_t> seen_;         // of all gauges: 1 or 0
  std::vector<WallLoad> loads_;
  std::vector<MirrorLoad> mirror_loads_;
  EnergyBudget budget_;
  std::optional<PressureEnvelope> envelope_;
  std::optional<ReflectionClock> reflections_;
  std::vector<std::size_t> placed_;  // the gauges whose places it has
  std::optional<double> rise_;       // Pa
  bool reads_walls_ = false;
  bool reads_budget_ = false;
};

}  // namespace moraine
