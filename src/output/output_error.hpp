// Failure to write what a run has to tell.
#pragma once

#include <stdexcept>

namespace moraine {

/// A file of results could not be written: no room, no rights, a broken disk. Not the fault of the
/// case or of the physics, so the program ends with a code of its own.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace moraine
