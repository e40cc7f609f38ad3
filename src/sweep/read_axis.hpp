// One [[parameter]] of a sweep file.
#pragma once

#include <optional>
#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"
#include "setup/toml.hpp"
#include "sweep/sweep_plan.hpp"

namespace moraine {

/// What the rest of the file says that matters to a parameter.
struct AxisContext {
  Case const& base;
  std::optional<SweepMethod> method;  // nothing where the file does not say it rightly
};

/// Reads and checks keys and values against the table of parameters of cases. Mistakes are
/// reported; then there is no axis. `prefix`: "parameter[1]."
std::optional<SweepAxis> read_axis(toml::table const& table, std::string const& prefix,
                                   AxisContext const& context, Source& source);

}  // namespace moraine
