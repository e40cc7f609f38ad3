// moraine verify: the verification suite.
#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "app/commands.hpp"
#include "verify/check.hpp"
#include "verify/report.hpp"

namespace moraine {
namespace {

int list_checks() {
  for (Check const& check : checks()) fmt::print("{:<22}{}\n", check.name, check.requirement);
  return ExitCode::done;
}

}  // namespace

int run_verify(VerifyOptions const& options) {
  if (options.list) return list_checks();
  if (options.threads > 0) omp_set_num_threads(options.threads);
  Colour const colour = isatty(STDOUT_FILENO) != 0 ? Colour::terminal : Colour::none;
  std::vector<CheckResult> all;
  for (Check const& check : choose_checks(options.names)) {
    auto const results = run_check(check, options.quick ? Effort::quick : Effort::full);
    if (!options.json)
      fmt::print("{}: {}\n{}\n", check.name, check.requirement, results_table(results, colour));
    std::fflush(stdout);
    all.insert(all.end(), results.begin(), results.end());
  }
  if (options.json)
    fmt::print("{}\n", to_json(all).dump(2));
  else
    fmt::print("{}\n", summary(all));
  bool const failed = std::ranges::any_of(all, [](CheckResult const& r) { return r.failed(); });
  return failed ? ExitCode::failed : ExitCode::done;
}

}  // namespace moraine
