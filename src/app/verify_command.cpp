// moraine verify: the verification suite.
#include <fmt/core.h>
#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "app/commands.hpp"
#include "output/atomic_file.hpp"
#include "verify/check.hpp"
#include "verify/report.hpp"
#include "verify/verification_page.hpp"

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
  std::vector<CheckRun> runs;
  Effort const effort = options.quick ? Effort::quick : Effort::full;
  for (Check const& check : choose_checks(options.names)) {
    auto const start = std::chrono::steady_clock::now();
    auto const results = run_check(check, effort);
    std::chrono::duration<double> const time = std::chrono::steady_clock::now() - start;
    runs.push_back({check.name, check.requirement, results, time.count()});
    if (!options.json)
      fmt::print("{}: {}\n{}\n", check.name, check.requirement, results_table(results, colour));
    std::fflush(stdout);
    all.insert(all.end(), results.begin(), results.end());
  }
  if (options.json)
    fmt::print("{}\n", to_json(all).dump(2));
  else
    fmt::print("{}\n", summary(all));
  if (!options.report.empty()) {
    AtomicFile page(options.report);
    page.stream() << verification_page(runs, effort);
    page.commit();
  }
  bool const failed = std::ranges::any_of(all, [](CheckResult const& r) { return r.failed(); });
  return failed ? ExitCode::failed : ExitCode::done;
}

}  // namespace moraine
