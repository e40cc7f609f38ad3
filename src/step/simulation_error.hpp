#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace moraine {

/// A run that cannot go on: says which particle, of which material, where, when and why.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace moraine
