// Reads the end state of another run, from which a case starts.
#pragma once

#include <filesystem>

#include "setup/case.hpp"

namespace moraine {

/// Reads the newest whole checkpoint in the folder `start.run` of a case into it, and checks that
/// case and state go together (setup/start_particles.hpp). Does nothing for a case that starts from
/// no other run. Particles that lay outside the domain of the other run, about to be removed there,
/// are left out. Throws InputErrors for a folder that is not there or holds no whole checkpoint,
/// for a checkpoint of another layout, and for what does not go together.
void read_start(Case& c);

/// Writes what read_start read into the folder of a run (`start.h5`, sealed like a checkpoint), so
/// that the run can go on without the other one. Throws OutputError.
void write_start_copy(Case const& c, std::filesystem::path const& folder);

/// Reads that copy. Throws std::runtime_error where it is missing or damaged.
void read_start_copy(Case& c, std::filesystem::path const& folder);

}  // namespace moraine
