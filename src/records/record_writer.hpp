// Writing ground motion records.
#pragma once

#include <filesystem>
#include <string>

#include "records/ground_record.hpp"

namespace moraine {

/// Two columns as CSV, `time [s]` and `acceleration [m/s^2]`, in digits that read back to the same
/// doubles, under a comment line with the name.
std::string record_as_csv(GroundRecord const& record);

/// The format AT2 of PEER: four header lines, accelerations in g with eight digits, five to a line.
/// A record that starts later than zero loses its start.
std::string record_as_at2(GroundRecord const& record);

/// Displacement of the ground over time as a motion file of moving walls: columns `time` and `axis`
/// ("x", "y" or "z"), in s and m.
std::string displacement_as_csv(GroundRecord const& record, std::string const& axis);

}  // namespace moraine
