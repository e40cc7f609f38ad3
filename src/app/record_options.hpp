// Options about ground motion records that several commands share.
#pragma once

#include <string>
#include <vector>

#include "app/unit_options.hpp"
#include "records/ground_record.hpp"

namespace CLI {
class App;
}

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

/// A record and the file that it comes from.
struct FileRecord {
  std::string file;
  GroundRecord record;
};

/// The records, read and processed. Mistakes go to `input`: records that have some are left out.
/// Those whose names are the same are called by their files.
std::vector<FileRecord> read_records(RecordOptions const& options, UnitOptions& input);

/// Says on stderr of records whose peak is above all that were recorded that their unit may be
/// wrong.
void warn_of_peaks(std::vector<GroundRecord> const& records);

/// The records alone.
std::vector<GroundRecord> without_files(std::vector<FileRecord> const& records);

}  // namespace moraine
