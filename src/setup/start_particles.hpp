// The particles that a case takes over from another run.
#pragma once

#include <cstddef>
#include <vector>

#include "base/input_error.hpp"
#include "setup/case.hpp"
#include "store/particle_store.hpp"

namespace moraine {

/// Which particles of the state that a case starts from stay: all whose places no region of the
/// case fills. Ascending; nothing for a case that starts from no other run. Throws
/// std::invalid_argument when the state has not been read.
std::vector<std::size_t> kept_start_particles(Case const& c);

/// The material of this case that has the name of a material of the other run.
MaterialId start_material(Case const& c, std::size_t other);

/// Whether particles of a material of the other run remembered how far they had been compacted. Of
/// one without pores they know nothing, whatever it is called here.
bool start_knows_compaction(Case const& c, std::size_t other);

/// Mistakes of a case that do not go with the state that it starts from: another dimension, another
/// spacing, a material that the case does not have, particles that lie outside the domain or more
/// than a quarter of the spacing inside a wall, and regions that leave none of its particles.
std::vector<InputProblem> start_problems(Case const& c);

/// Doubts about it: other constants of a material, a run that had not reached its end, regions that
/// replace more than half of its particles. The state must have been read.
void add_start_warnings(Case const& c, std::vector<InputProblem>& warnings);

}  // namespace moraine
