// How large a case is, before any particle is made.
#pragma once

#include "setup/case.hpp"

namespace moraine {

/// Estimates of numbers of particles and of the memory that a run needs.
struct CaseSize {
  double fluid = 0.0;
  double walls = 0.0;
  double bytes = 0.0;  // of the run and of a checkpoint while it is written
  double particles() const { return fluid + walls; }
};

/// Costs the same for any spacing. Walls are counted as layers on their closed sides.
CaseSize estimate_size(Case const& c);

/// Memory of this machine in bytes.
double machine_memory();

/// Throws InputErrors at the key of the spacing that makes most of them for a case of more
/// particles than indices can count, or that needs more than `memory` bytes; says which spacing
/// would fit. Regions so far apart that the places between them cannot be counted through are
/// refused too.
void check_size(Case const& c, double memory = machine_memory());

}  // namespace moraine
