// Rules of wall methods: what goes together.
#pragma once

#include <string>
#include <vector>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports mirrors that are no containers at rest, repulsion that is missing or has no effect, slip
/// of walls that cannot hold the fluid, and stages that remove walls without dummies. `walls`,
/// `stages`: their keys.
void check_wall_methods(Case const& c, std::vector<std::string> const& walls,
                        std::vector<std::string> const& stages, Source& source);

/// Reports mirror walls that claim one side of the domain together. Needs the domain.
void check_mirror_sides(Case const& c, std::vector<std::string> const& walls, Source& source);

/// Adds warnings of walls whose particles push at the start, and of mirrors that cut the lattice.
void add_wall_warnings(Case const& c, std::vector<InputProblem>& warnings);

}  // namespace moraine
