// One [[output]] of a sweep file.
#pragma once

#include <optional>
#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"
#include "setup/toml.hpp"
#include "sweep/sweep_output.hpp"

namespace moraine {

/// What there is to take from: the case, and whether its members know when a pressure arrives.
struct OutputContext {
  Case const& base;
  bool has_arrivals;
};

/// Reads an output and checks it against the gauges and tables that the case will have. Mistakes
/// are reported; then there is none. `prefix`: "output[1]."
std::optional<SweepOutput> read_output(toml::table const& table, std::string const& prefix,
                                       OutputContext const& context, Source& source);

}  // namespace moraine
