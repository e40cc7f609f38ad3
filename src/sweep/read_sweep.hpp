// From a sweep file to a plan whose members are all known to be good.
#pragma once

#include <filesystem>

#include "sweep/case_template.hpp"
#include "sweep/sweep_plan.hpp"

namespace moraine {

/// A plan, and the case that its members are made of.
struct Sweep {
  SweepPlan plan;
  CaseTemplate cases;
};

/// Reads a sweep file and checks it against its case. Throws InputErrors with all mistakes of the
/// file and all mistakes that members have and the case has not, each said once. A case with
/// mistakes of its own hides what depends on it.
Sweep read_sweep(std::filesystem::path const& file);

/// The values of a member as replacements for the case.
std::vector<Replacement> replacements_of(SweepPlan const& plan, SweepMember const& member);

}  // namespace moraine
