// Elastic material without limit.
#pragma once

#include "matter/strength/deviator.hpp"

namespace moraine {

/// Hooke's law in shear at any stress; the pressure is that of the equation of state.
struct Elastic {
  static constexpr char const* name = "elastic";

  double shear_modulus = 0.0;  // Pa, G

  MORAINE_HD Deviator limit(Deviator const& s, double) const { return s; }
};

}  // namespace moraine
