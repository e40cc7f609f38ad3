// Results of the verification suite as a page for browsers.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/check.hpp"

namespace moraine {

/// A check that was run: what it found and how long that took.
struct CheckRun {
  std::string_view name;
  std::string_view requirement;
  std::vector<CheckResult> results;
  double seconds = 0.0;
};

/// One self-contained HTML file without scripts: how many results pass, then a table for each check
/// with a bar for the part of the tolerance that each result takes.
std::string verification_page(std::span<CheckRun const> runs, Effort effort);

}  // namespace moraine
