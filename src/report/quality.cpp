#include "report/quality.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <vector>

#include "output/balances.hpp"

namespace moraine::report {
namespace {

/// Rows as they come.
class Rows {
 public:
  void add(std::string name, Verdict verdict, std::string value, std::string limit,
           std::string meaning) {
    rows_.push_back({{"name", std::move(name)},
                     {"verdict", verdict_name(verdict)},
                     {"value", std::move(value)},
                     {"limit", std::move(limit)},
                     {"meaning", std::move(meaning)}});
  }
  Json take() { return std::move(rows_); }

 private:
  Json rows_ = Json::array();
};

std::string per_cent(double share) {
  return std::isfinite(share) ? fmt::format("{:.2g} %", 100.0 * share) : "no number";
}

/// Between periodic sides potential energy has no zero: a particle that crosses them falls for
/// ever.
bool falls_around(Case const& c) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (c.periodic[axis] && c.gravity[axis] != 0.0) return true;
  return false;
}

/// Symmetry planes take momentum across them, which nobody books.
std::array<bool, 3> axes_without_planes(Case const& c) {
  std::array<bool, 3> axes{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    axes[axis] = !c.symmetry.planes[axis][0] && !c.symmetry.planes[axis][1] &&
                 static_cast<int>(axis) < c.dimension;
  return axes;
}

Verdict graded(double share, double good, double bad) {
  if (std::isnan(share)) return Verdict::bad;
  if (share < good) return Verdict::good;
  return share < bad ? Verdict::doubtful : Verdict::bad;
}

void add_end(RunFiles const& run, Rows& rows) {
  std::string_view const state = state_of(run);
  std::string reason = end_reason(run);
  if (reason.empty()) reason = state == "running" ? "still running" : "no end was written: killed?";
  Verdict const verdict = state == "ended"    ? Verdict::good
                          : state == "broken" ? Verdict::bad
                                              : Verdict::doubtful;
  rows.add("end", verdict, std::move(reason), "end time reached",
           "A run that was stopped or broke off says nothing about what comes later.");
  double const to_come = number_at(run.status, "stages_to_come").value_or(0.0);
  if (state == "ended" && to_come > 0.0)
    rows.add("stages", Verdict::bad, fmt::format("{} never began", to_come), "all",
             "The condition that ends a stage did not come true before the end of the run.");
}

void add_energy(RunFiles const& run, Rows& rows) {
  constexpr char const* name = "energy that nobody booked";
  constexpr char const* meaning =
      "Kinetic, internal, potential and lost energy, less the work of walls, damping and "
      "detonations, against the start; by the largest change of one of the three.";
  auto const drift = energy_drift(run.sums);
  if (!drift) return;
  if (run.used_case && falls_around(*run.used_case))
    return rows.add(name, Verdict::unknown, "not known: gravity along periodic sides", "1 %",
                    meaning);
  rows.add(name, graded(drift->share(), 0.01, 0.05),
           fmt::format("{:.3g} J, {}", drift->largest, per_cent(drift->share())), "1 %", meaning);
}

/// Who takes momentum along that nobody books; empty: nobody.
std::string thief_of_momentum(RunFiles const& run, std::array<bool, 3> const& axes) {
  if (last_of(run.sums, "damping_work").value_or(0.0) != 0.0) return "damping";
  if (last_of(run.sums, "lost_particles").value_or(0.0) != 0.0) return "lost particles";
  return axes[0] || axes[1] || axes[2] ? "" : "symmetry planes";
}

void add_momentum(RunFiles const& run, Rows& rows) {
  if (!run.used_case) return;
  auto const axes = axes_without_planes(*run.used_case);
  auto const drift = momentum_drift(run.sums, run.used_case->gravity, axes);
  if (!drift) return;
  std::string const thief = thief_of_momentum(run, axes);
  bool const known = thief.empty();
  rows.add(
      "momentum that nobody gave", known ? graded(drift->share(), 1e-3, 1e-2) : Verdict::unknown,
      known ? fmt::format("{:.3g} kg m/s, {}", drift->largest, per_cent(drift->share()))
            : "not known: taken along by " + thief,
      "0.1 %",
      "Change of momentum against the impulses of walls and gravity, along axes without symmetry "
      "planes; by the momentum of the largest kinetic energy.");
}

void add_lost(RunFiles const& run, Rows& rows) {
  auto const lost = last_of(run.sums, "lost_particles");
  auto const left = last_of(run.sums, "particles");
  if (!lost || !left) return;
  double const share = *lost > 0.0 ? *lost / (*lost + *left) : 0.0;
  rows.add("particles that left the domain", *lost > 0.0 ? Verdict::doubtful : Verdict::good,
           *lost > 0.0 ? fmt::format("{:.0f}, {}", *lost, per_cent(share)) : "none", "none",
           "Ejecta may leave; water that leaves a closed tank must not.");
}

/// What a guard has to say: it looked, it was switched off, or it cannot see what it looks for.
void add_guard(nlohmann::json const& guard, Rows& rows) {
  std::string const name = "guard: " + text_at(guard, "name");
  std::string const meaning =
      "Looks at " + text_at(guard, "looks_at") + "; the run stops at its bound.";
  std::string const blind = text_at(guard, "not_looking");
  if (!blind.empty())
    return rows.add(name, blind == "switched off" ? Verdict::doubtful : Verdict::unknown, blind,
                    "100 %", meaning);
  auto const part = number_at(guard, "largest_part_of_bound");
  rows.add(name, part ? graded(*part, 0.5, 1.0) : Verdict::bad,
           part ? per_cent(*part) + " of its bound" : "no number", "100 %", meaning);
}

void add_guards(RunFiles const& run, Rows& rows) {
  if (!run.status.contains("guards") || !run.status["guards"].is_array()) return;
  for (auto const& guard : run.status["guards"])
    if (guard.is_object()) add_guard(guard, rows);
}

void add_clips(RunFiles const& run, Rows& rows) {
  if (!run.status.contains("smoothing_clips")) return;
  auto const& clips = run.status["smoothing_clips"];
  double const count =
      number_at(clips, "at_least").value_or(0.0) + number_at(clips, "at_most").value_or(0.0);
  if (count > 0.0)
    rows.add("smoothing lengths cut off", Verdict::doubtful,
             fmt::format("up to {:.0f} particles", count), "none",
             "They met resolution.smoothing.least or most, and no longer follow the density.");
}

void add_gauges(RunFiles const& run, Rows& rows) {
  if (!run.gauge_summary.contains("gauges") || !run.gauge_summary["gauges"].is_array()) return;
  std::string blind;
  for (auto const& gauge : run.gauge_summary["gauges"])
    if (gauge.is_object() && gauge.contains("seen") && gauge["seen"] == false)
      blind += (blind.empty() ? "" : ", ") + text_at(gauge, "name");
  bool const all = blind.empty();
  rows.add(
      "gauges", all ? Verdict::good : Verdict::doubtful,
      all ? "all have seen something" : "have seen nothing: " + blind, "all",
      "A gauge that never meets a particle, a wet wall or a surface stands in the wrong place.");
}

}  // namespace

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::good:
      return "good";
    case Verdict::doubtful:
      return "doubtful";
    case Verdict::bad:
      return "bad";
    default:
      return "unknown";
  }
}

Json quality_of(RunFiles const& run) {
  Rows rows;
  add_end(run, rows);
  add_energy(run, rows);
  add_momentum(run, rows);
  add_lost(run, rows);
  add_guards(run, rows);
  add_clips(run, rows);
  add_gauges(run, rows);
  for (std::string const& note : run.notes)
    rows.add("files", Verdict::unknown, note, "", "This piece of the report is missing.");
  return rows.take();
}

}  // namespace moraine::report
