// How a run tells that it cannot go on.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace moraine {

/// A particle, by its global id, and what it is flagged for: flag_of(guard).
struct Flag {
  std::uint64_t particle = 0;
  int guard = 0;
};

/// A run that cannot go on: says which particle, of which material, where, when and why, and flags
/// all particles that a guard names.
class SimulationError : public std::runtime_error {
 public:
  explicit SimulationError(std::string const& message, std::vector<Flag> flags = {})
      : std::runtime_error(message), flags_(std::move(flags)) {}

  /// In ascending order of the ids, each particle once.
  std::vector<Flag> const& flags() const { return flags_; }

 private:
  std::vector<Flag> flags_;
};

}  // namespace moraine
