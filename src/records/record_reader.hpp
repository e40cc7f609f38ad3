// Reading ground motion records.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "records/ground_record.hpp"

namespace moraine {

/// What the user says about a file.
struct RecordHints {
  std::string unit;                 // of the acceleration; empty: as the file says
  std::optional<double> time_step;  // s; for files without times
};

/// What one of a unit of acceleration is [m/s^2]: "g" and "g0" (standard gravity), "gal", or any
/// acceleration that UDUNITS-2 knows ("m/s2", "cm/s^2"), in capitals too ("CM/SEC/SEC"). Nothing
/// for other texts.
std::optional<double> acceleration_unit(std::string_view unit);

/// Reads a record from a text, one of
///   AT2         the files of PEER: header lines, the last with NPTS and DT, then numbers
///   two columns time and acceleration at equal steps, separated by commas, semicolons, tabs or
///               blanks, under an optional line of column names with units: "time [s]" or "t_s",
///               "acceleration [g]" or "a_m_s2"
///   plain       accelerations, any number in a line; the step must be told
/// Empty lines and lines that start with #, % or ! do not count, nor do the words before a plain or
/// two-column table that carry no unit. The unit comes from the file or from the hints; a file that
/// states another one than the hints is refused. `name` stands in messages, its stem becomes the
/// name of the record.
///
/// Throws InputErrors with all mistakes: no text, words, infinities or decimal commas among the
/// numbers, another count than NPTS, gaps and uneven steps of time, no unit, no step, fewer than
/// two values, a velocity or displacement instead of an acceleration.
GroundRecord parse_record(std::string_view text, std::string const& name, RecordHints const& hints);

/// The same from a file of at most 100 MB. Throws InputErrors also where it cannot be read.
GroundRecord read_record(std::filesystem::path const& path, RecordHints const& hints);

}  // namespace moraine
