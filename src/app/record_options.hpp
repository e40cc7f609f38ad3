// Options about ground motion records that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/unit_options.hpp"
#include "records/ground_record.hpp"

namespace moraine {

/// As the user writes them.
struct RecordOptions {
  std::vector<std::string> files;
  std::string unit;
  std::string time_step;
  std::string until;
  std::string high_pass;
  std::string low_pass;
  double time_scale = 1.0;
  std::string resample;
  bool straight_lines = false;
  std::string baseline = "none";
  std::string pga;
};

/// Makes all but the files known to a command.
void add_record_options(CLI::App& command, RecordOptions& options);

/// The records, read and processed. Mistakes go to `input`: records that have some are left out.
std::vector<GroundRecord> read_records(RecordOptions const& options, UnitOptions& input);

}  // namespace moraine
