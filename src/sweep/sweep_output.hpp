// Numbers that are taken from the files of a run: of a gauge, of the conserved sums, of the run.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// What is taken of a column of readings.
enum class Measure : std::uint8_t {
  largest,
  time_of_largest,
  smallest,
  time_of_smallest,
  last,
  integral,
  impulse,
  arrival,
  duration,
  decay_exponent  // of a line with an origin
};
inline constexpr std::array<std::string_view, 10> measure_names{
    "largest",  "time_of_largest", "smallest", "time_of_smallest", "last",
    "integral", "impulse",         "arrival",  "duration",         "decay_exponent"};

/// What is taken of a run as a whole.
enum class RunNumber : std::uint8_t { wall_time, steps, simulated_time, particles, energy_error };
inline constexpr std::array<std::string_view, 5> run_number_names{
    "wall_time", "steps", "simulated_time", "particles", "energy_error"};

enum class OutputSource : std::uint8_t { gauge, sums, run };

/// One number of a run.
struct SweepOutput {
  OutputSource from = OutputSource::gauge;
  std::string gauge;                    // of gauges
  std::string column;                   // of gauges and sums, as their tables name it
  Measure measure = Measure::largest;   // of gauges and sums
  RunNumber number = RunNumber::steps;  // of runs
  std::string label;
  std::string unit;
};

/// Unit of a measure of a column with this unit.
std::string unit_of(Measure measure, std::string const& column_unit);
std::string unit_of(RunNumber number);

/// The numbers of a run that has ended, in the order of the outputs; not a number where the run has
/// none, such as an arrival that did not come. `energy_error`: the energy that nobody booked, as
/// the page of the run tells it (output/balances.hpp). Throws std::runtime_error if a file is
/// missing or malformed.
std::vector<double> read_outputs(std::vector<SweepOutput> const& outputs,
                                 std::filesystem::path const& folder);

}  // namespace moraine
