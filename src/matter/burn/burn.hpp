// How an explosive burns: law of the front, and where it starts.
#pragma once

#include "matter/burn/ignition.hpp"
#include "matter/burn/programmed_burn.hpp"

namespace moraine {

struct Burn {
  ProgrammedBurn law;
  Ignition ignition;
};

}  // namespace moraine
