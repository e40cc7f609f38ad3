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
:root { color-scheme: light dark; --line: #8884; --good: #1a7f37; --bad: #c1121f; --known: #9a6700; --none: #777; }
@media (prefers-color-scheme: dark) { :root { --good: #4cc38a; --bad: #ff6b6b; --known: #d4a72c; --none: #aaa; } }
body { font: 15px/1.45 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 72rem; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin: 2rem 0 0.2rem; }
p { margin: 0.2rem 0 0.6rem; } .scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: left; padding: 0.25rem 0.6rem 0.25rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { font-weight: 500; opacity: 0.75; } td.number, th.number { text-align: right; white-space: nowrap; }
.good { color: var(--good); } .bad { color: var(--bad); font-weight: 600; } .none { color: var(--none); }
.known { color: var(--known); }
.bar { display: inline-block; width: 6rem; height: 0.6rem; background: var(--line); }
.bar i { display: block; height: 100%; background: currentColor; }
)css";

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "-";
}

struct Look {
  char const* style;  // class of the style sheet
  char const* mark;
  char const* word;
};

Look look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return {"good", "&#10003;", "pass"};
    case Verdict::fail:
      return {"bad", "&#10007;", "fail"};
    case Verdict::known:
      return {"known", "&#9679;", "known"};
    case Verdict::skip:
      return {"none", "&#9675;", "skipped"};
  }
  return {"", "", ""};
}

std::string verdict(CheckResult const& result) {
  Look const look = look_of(result.verdict());
  return fmt::format("<span class=\"{}\">{} {}</span>", look.style, look.mark, look.word);
}

/// What was measured, and where it says why the tolerance is not met.
std::string words_of(CheckResult const& result) {
  if (result.verdict() != Verdict::known) return html_escaped(result.note);
  return fmt::format("{}; explained in {}, regression bound &#177; {:.3g}",
                     html_escaped(result.note), html_escaped(result.explained_in), result.worst);
}

/// The part of the tolerance that the difference takes, as a bar.
std::string bar(CheckResult const& result) {
  double const part = std::abs(result.measured - result.reference) / result.tolerance;
  if (result.from_below || !std::isfinite(part)) return "";
  return fmt::format(
      "<span class=\"bar {}\" title=\"{:.0f} % of the tolerance\"><i style=\"width: "
      "{:.0f}%\"></i></span>",
      look_of(result.verdict()).style, 100.0 * part, 100.0 * std::min(part, 1.0));
}

std::string row(CheckResult const& result) {
  if (result.skipped)
    return fmt::format("<tr><td>{}</td><td>{}</td><td colspan=\"5\"></td><td>{}</td></tr>\n",
                       verdict(result), html_escaped(result.name), html_escaped(result.note));
  return fmt::format(
      "<tr><td>{}</td><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
      "class=\"number\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
      verdict(result), html_escaped(result.name), number(result.measured),
      (result.from_below ? "&#8804; " : "") + number(result.reference),
      result.from_below ? "" : number(result.tolerance), html_escaped(result.unit), bar(result),
      words_of(result));
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
  std::string text;
  for (Verdict const verdict : {Verdict::pass, Verdict::fail, Verdict::known, Verdict::skip}) {
    std::size_t count = 0;
    for (CheckRun const& run : runs)
      for (CheckResult const& result : run.results) count += result.verdict() == verdict ? 1 : 0;
    Look const look = look_of(verdict);
    text += fmt::format("{}<span class=\"{}\">{} {} {}</span>", text.empty() ? "" : ", ",
                        count > 0 ? look.style : "none", look.mark, count, look.word);
  }
  return text;
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
      "tolerance. What is known does not, and a page says why.</p>\n{}</body>\n</html>\n",
      style, counts(runs), effort == Effort::quick ? "Quick" : "Full", html_escaped(build.version),
      html_escaped(build.git_revision), html_escaped(build.compiler), html_escaped(build.simd),
      utc_now(), body);
}

}  // namespace moraine
