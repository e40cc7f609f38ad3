// The tables of a sweep file as data: what its keys are called and may hold.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "setup/binding.hpp"
#include "sweep/draws.hpp"
#include "sweep/sweep_output.hpp"
#include "sweep/sweep_plan.hpp"

namespace moraine {

/// The top of the file.
struct SweepHead {
  std::string title;
  std::string case_file;
  SweepMethod method = SweepMethod::grid;
  int at_once = 1;
  std::optional<int> samples;
  std::optional<int> seed;
};
std::span<Entry<SweepHead> const> sweep_head_entries();

/// What [[parameter]] says beside `key`, `keys`, `values`, `range` and `label`, whose types depend
/// on each other.
enum class RangeScale : std::uint8_t { linear, log };
struct AxisHead {
  std::optional<int> steps;
  RangeScale scale = RangeScale::linear;
};
std::span<Entry<AxisHead> const> axis_entries();

/// An item of [[output]].
struct OutputHead {
  std::string gauge, sums, column, label;
  Measure measure = Measure::largest;
  RunNumber run = RunNumber::steps;
};
std::span<Entry<OutputHead> const> output_entries();

}  // namespace moraine
