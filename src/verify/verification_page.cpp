#include "verify/verification_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "output/manifest.hpp"
#include "report/html_text.hpp"

namespace moraine {
namespace {

using report::html_escaped;

constexpr char const* style = R"css(
:root { color-scheme: light dark; --line: #8884; --good: #1a7f37; --bad: #c1121f; --none: #777; }
@media (prefers-color-scheme: dark) { :root { --good: #4cc38a; --bad: #ff6b6b; --none: #aaa; } }
body { font: 15px/1.45 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 72rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin: 2rem 0 0.2rem; }
p { margin: 0.2rem 0 0.6rem; } .scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 0.25rem 0.6rem 0.25rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { font-weight: 500; opacity: 0.75; } td.number, th.number { text-align: right; white-space: nowrap; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; } .none { color: var(--none); }
.bar { display: inline-block; width: 6rem; height: 0.6rem; background: var(--line); }
.bar i { display: block; height: 100%; background: currentColor; }
)css";

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

std::string verdict(CheckResult const& result) {
  if (result.skipped) return "<span class=\"none\">&#9675; skipped</span>";
  return result.pass ? "<span class=\"good\">&#10003; pass</span>"
                     : "<span class=\"bad\">&#10007; fail</span>";
}

/// The part of the tolerance that the difference takes, as a bar.
std::string bar(CheckResult const& result) {
  double const part = std::abs(result.measured - result.reference) / result.tolerance;
  if (!std::isfinite(part)) return "";
  return fmt::format(
      "<span class=\"bar {}\" title=\"{:.0f} % of the tolerance\"><i style=\"width: "
      "{:.0f}%\"></i></span>",
      result.pass ? "good" : "bad", 100.0 * part, 100.0 * std::min(part, 1.0));
}

std::string row(CheckResult const& result) {
  if (result.skipped)
    return fmt::format("<tr><td>{}</td><td>{}</td><td colspan=\"5\"></td><td>{}</td></tr>\n",
                       verdict(result), html_escaped(result.name), html_escaped(result.note));
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
      "class=\"number\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      verdict(result), html_escaped(result.name), number(result.measured), number(result.reference),
      number(result.tolerance), html_escaped(result.unit), bar(result), html_escaped(result.note));
}

std::string section(CheckRun const& run) {
  std::string rows;
  for (CheckResult const& result : run.results) rows += row(result);
  return fmt::format(
      "<h2 id=\"{0}\">{0}</h2>\n<p>{1} <span class=\"none\">({2:.1f} s)</span></p>\n<div "
      "class=\"scroll\"><table>\n<tr><th></th><th>result</th><th class=\"number\">measured</th><th "
      "class=\"number\">reference</th><th class=\"number\">tolerance</th><th>unit</th><th>of the "
      "tolerance</th><th>what</th></tr>\n{3}</table></div>\n",
      html_escaped(run.name), html_escaped(run.requirement), run.seconds, rows);
}

std::string counts(std::span<CheckRun const> runs) {
  std::size_t passed = 0, failed = 0, skipped = 0;
  for (CheckRun const& run : runs)
    for (CheckResult const& result : run.results)
      ++(result.skipped ? skipped : result.pass ? passed : failed);
  return fmt::format(
      "<span class=\"good\">&#10003; {} pass</span>, <span class=\"{}\">&#10007; {} "
      "fail</span>, <span class=\"none\">&#9675; {} skipped</span>",
      passed, failed > 0 ? "bad" : "none", failed, skipped);
}

}  // namespace

std::string verification_page(std::span<CheckRun const> runs, Effort effort) {
  BuildInfo const build = build_info();
  std::string body;
  for (CheckRun const& run : runs) body += section(run);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Verification of "
      "Moraine</title>\n<style>{}</style>\n</head>\n<body>\n<h1>Verification of Moraine</h1>\n"
      "<p>{}. {} effort.</p>\n<p>Version {}, revision {}, {}, {}; {}. Each result is a number "
      "beside an exact or a measured one; it passes when they differ by no more than the "
      "tolerance.</p>\n{}</body>\n</html>\n",
      style, counts(runs), effort == Effort::quick ? "Quick" : "Full", html_escaped(build.version),
      html_escaped(build.git_revision), html_escaped(build.compiler), html_escaped(build.simd),
      utc_now(), body);
}

}  // namespace moraine
