// What a check of the verification suite is, and the list of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// What a result says of the tolerance: that it holds, that it does not, that it does not for a
/// reason that a page explains, or nothing.
enum class Verdict { pass, fail, known, skip };

/// One number that the program produced, beside what it should be. It passes when it is a number
/// and differs from the reference by no more than the tolerance; all three are in `unit`.
struct CheckResult {
  std::string name;  // "sod: density"
  double measured = 0.0;
  double reference = 0.0;
  double tolerance = 0.0;
  std::string unit;  // "-" for plain numbers
  bool pass = false;
  std::string note;            // what was measured, in words
  bool skipped = false;        // nothing was measured: the note says what it takes
  bool from_below = false;     // the reference is a limit: anything below it passes
  double worst = 0.0;          // regression bound: the difference of one that is known may not
                               // exceed it
  std::string explained_in{};  // the page that says why the tolerance is not met; may be empty

  Verdict verdict() const;
  bool failed() const { return verdict() == Verdict::fail; }
};

/// Fills in whether it passes.
CheckResult compare(std::string name, double measured, double reference, double tolerance,
                    std::string unit, std::string note);

/// The same for a quantity that should vanish: |measured| <= limit.
CheckResult at_most(std::string name, double measured, double limit, std::string unit,
                    std::string note);

/// The same for a quantity that only must not be larger: measured <= limit.
CheckResult below(std::string name, double measured, double limit, std::string unit,
                  std::string note);

/// A result that may miss its tolerance, for the reason that `page` gives (a path below the root of
/// the sources): then it is known, which is no failure, as long as |measured - reference| <=
/// `worst`. That bound lies a little beyond what is measured: it says that nothing has become
/// worse, and nothing of the physics.
CheckResult explained(CheckResult result, double worst, std::string page);

/// A number that cannot be had here and now, because data of others are not there or the effort is
/// too small for it. It neither passes nor fails.
CheckResult skip(std::string name, std::string why);

/// How thorough a check is: `quick` takes coarser resolutions or shorter runs under the same
/// tolerances.
enum class Effort { full, quick };

/// A check of the program against an exact or a measured result. `run` needs nothing but the
/// program itself; numbers that take a file of reference_data.hpp are skipped where it is not
/// there.
struct Check {
  std::string_view name;
  std::string_view requirement;  // one sentence
  std::vector<CheckResult> (*run)(Effort);
};

/// All checks, in the order in which they run.
std::span<Check const> checks();

/// The check of this name, if there is one.
std::optional<Check> find_check(std::string_view name);

/// The checks of these names, all without names. Throws InputErrors for names that no check has.
std::vector<Check> choose_checks(std::vector<std::string> const& names);

/// Runs a check. A simulation that breaks down, or anything else that is thrown, is a result that
/// does not pass and says why.
std::vector<CheckResult> run_check(Check const& check, Effort effort);

}  // namespace moraine
