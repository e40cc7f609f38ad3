// moraine motion: ground motion records, their measures and spectra, and synthetic ones.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/record_options.hpp"

namespace CLI {
class App;
}

namespace moraine {

struct SynthesisOptions {
  std::string pga;
  std::string velocity_ratio;
  std::string predominant_period;
  std::string duration = "20 s";
  std::string time_step = "0.005 s";
  double rise = 0.15, stay = 0.55;
  std::uint64_t seed = 1;
};

/// What both write.
struct MotionOutputs {
  bool json = false, csv = false, force = false;
  std::string record;        // file
  std::string displacement;  // file
  std::string axis = "x";
  std::string spectra;      // file
  std::string frequencies;  // file
  std::string plot;         // file
};

struct MotionOptions {
  RecordOptions records;
  std::string shortest_period, longest_period = "4 s";
  double damping = 0.05;
  SynthesisOptions synthesis;
  MotionOutputs out;
};

/// Makes the command and its subcommand known to the command line.
void add_motion_command(CLI::App& app, MotionOptions& options);

/// Runs the command if it is this one: exit code, or nothing for another command.
std::optional<int> run_motion_command(CLI::App const& app, MotionOptions const& options);

}  // namespace moraine
