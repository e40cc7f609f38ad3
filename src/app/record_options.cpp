#include "app/record_options.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "base/gravity.hpp"
#include "records/processing.hpp"
#include "records/record_reader.hpp"

namespace moraine {
namespace {

constexpr char const* group = "Records";

Processing processing_of(RecordOptions const& options, UnitOptions& input) {
  Processing p;
  p.until = input.positive("--until", options.until, Quantity::time);
  p.high_pass = input.positive("--high-pass", options.high_pass, Quantity::frequency);
  p.low_pass = input.positive("--low-pass", options.low_pass, Quantity::frequency);
  p.time_scale = options.time_scale;
  if (!(options.time_scale > 0.0) || !std::isfinite(options.time_scale))
    input.mistake("--time-scale", fmt::format("{:g}", options.time_scale), "is not positive");
  p.time_step = input.positive("--resample", options.resample, Quantity::time);
  p.interpolation = options.straight_lines ? Interpolation::linear : Interpolation::band_limited;
  auto const found = std::find(baseline_names.begin(), baseline_names.end(), options.baseline);
  if (found == baseline_names.end())
    input.mistake("--baseline", "\"" + options.baseline + "\"", "is no baseline correction",
                  name_hint(options.baseline, baseline_names));
  else
    p.baseline = static_cast<Baseline>(found - baseline_names.begin());
  p.peak = input.positive("--pga", options.pga, Quantity::acceleration);
  return p;
}

}  // namespace

void add_record_options(CLI::App& command, RecordOptions& options) {
  command
      .add_option("--unit", options.unit,
                  "of accelerations, where the file has none: g, m/s2, cm/s2")
      ->group(group);
  command
      .add_option("--time-step", options.time_step,
                  "of files without times, for example \"0.01 s\"")
      ->group(group);
  command.add_option("--until", options.until, "leave out what comes later")->group(group);
  command
      .add_option("--high-pass", options.high_pass, "corner of a filter, for example \"0.1 Hz\"")
      ->group(group);
  command.add_option("--low-pass", options.low_pass, "corner of a filter, for example \"25 Hz\"")
      ->group(group);
  command.add_option("--time-scale", options.time_scale, "factor of all times, for models: 0.25")
      ->group(group);
  command.add_option("--resample", options.resample, "another step, for example \"0.01 s\"")
      ->group(group);
  command
      .add_flag("--straight-lines", options.straight_lines,
                "resample along straight lines, not band-limited")
      ->group(group);
  command
      .add_option("--baseline", options.baseline,
                  "correction: none, mean, linear, quadratic, cubic, rest")
      ->capture_default_str()
      ->group(group);
  command.add_option("--pga", options.pga, "scale to this peak, for example \"0.35 g0\"")
      ->group(group);
}

std::vector<FileRecord> read_records(RecordOptions const& options, UnitOptions& input) {
  Processing const processing = processing_of(options, input);
  RecordHints hints{options.unit, input.positive("--time-step", options.time_step, Quantity::time)};
  if (!options.unit.empty() && !acceleration_unit(options.unit)) {
    input.mistake("--unit", "\"" + options.unit + "\"", "is no unit of acceleration",
                  "choose g, m/s2 or cm/s2");
    hints.unit.clear();
  }
  std::vector<FileRecord> records;
  for (std::string const& file : options.files) try {
      records.push_back({file, processed(read_record(file, hints), processing)});
    } catch (InputErrors const& errors) {
      input.add(errors);
    } catch (std::invalid_argument const& error) {
      input.add(file, error.what());
    }
  std::map<std::string, int> uses;
  for (FileRecord const& entry : records) ++uses[entry.record.name];
  for (FileRecord& entry : records)
    if (uses[entry.record.name] > 1) entry.record.name = entry.file;
  return records;
}

void warn_of_peaks(std::vector<GroundRecord> const& records) {
  constexpr double believable = 5.0;  // g; the largest so far is about 4, Iwate-Miyagi 2008
  for (GroundRecord const& record : records)
    if (double const peak = peak_of(record, record.acceleration).value / standard_gravity;
        peak > believable)
      fmt::print(stderr,
                 "warning: {}: a peak of {:.3g} g is more than any earthquake had; is the unit of "
                 "the record right?\n",
                 record.name, peak);
}

std::vector<GroundRecord> without_files(std::vector<FileRecord> const& records) {
  std::vector<GroundRecord> result;
  for (FileRecord const& entry : records) result.push_back(entry.record);
  return result;
}

}  // namespace moraine
