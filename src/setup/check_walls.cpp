#include "setup/check_walls.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "setup/lattice.hpp"
#include "setup/mirror_walls.hpp"
#include "setup/parameter.hpp"

namespace moraine {
namespace {

void check_mirror(WallSpec const& wall, std::string const& key, Source& source) {
  if (!source.good(key + "method")) return;
  if (wall.form == WallForm::solid)
    source.report_value(key + "method", "makes images beyond the sides of a container only",
                        "obstacles are \"dummy\" or \"repulsive\"");
  else if (wall.motion.given())
    source.report_value(key + "method", "makes images at walls at rest only, but motion is given",
                        "walls that move are \"dummy\" or \"repulsive\"");
}

void check_repulsion(WallSpec const& wall, std::string const& key, Source& source) {
  if (source.has_problem(key + "method")) return;
  if (!wall.pushes()) {
    for (auto const* name : {"repulsion", "repulsion_range"})
      if (source.good(key + name))
        source.report_value(key + name, "has no effect: the method of the wall does not push",
                            "leave it out, or let method be \"repulsive\"");
    return;
  }
  if (!source.has(key + "repulsion"))
    source.report_key(key + "repulsion", source.place_of(key + "method"),
                      "is missing: the method pushes, and needs to know how hard",
                      "5 g H for a tank of depth H, or the sound speed squared");
  if (wall.method == WallMethod::repulsive && wall.slip == Slip::none && source.good(key + "slip"))
    source.report_value(key + "slip", "is not possible: a wall that only pushes has no friction",
                        "use \"dummy\" or \"mirror_and_repulsive\"");
}

}  // namespace

void check_wall_methods(Case const& c, std::vector<std::string> const& walls,
                        std::vector<std::string> const& stages, Source& source) {
  for (std::size_t i = 0; i < c.walls.size(); ++i) {
    if (c.walls[i].mirrors()) check_mirror(c.walls[i], walls[i] + '.', source);
    check_repulsion(c.walls[i], walls[i] + '.', source);
  }
  for (std::size_t i = 0; i < c.stages.size(); ++i) {
    std::string const key = stages[i] + ".remove_wall";
    for (WallSpec const& wall : c.walls)
      if (wall.name == c.stages[i].remove_wall && wall.method != WallMethod::dummy &&
          source.good(key))
        source.report_value(key, "is a wall without dummy particles, which cannot be removed",
                            "let its method be \"dummy\"");
  }
}

void check_mirror_sides(Case const& c, std::vector<std::string> const& walls, Source& source) {
  auto const sides = mirror_sides(c);
  for (std::size_t w = 0; w < c.walls.size(); ++w) {
    Case alone = c;
    alone.walls = {c.walls[w]};
    auto const own = mirror_sides(alone);
    std::string const key = walls[w] + ".method";
    for (std::size_t side = 0; side < side_names.size(); ++side) {
      auto const& first = sides[side / 2][side % 2];
      if (!own[side / 2][side % 2] || !first || *first == w || !source.good(key)) continue;
      source.report_value(key, fmt::format("makes images beyond {}, but wall \"{}\" does so too",
                                           side_names[side], c.walls[*first].name));
    }
  }
}

void add_wall_warnings(Case const& c, std::vector<InputProblem>& warnings) {
  double const half = 0.5 * c.numerics.spacing;
  for (WallSpec const& wall : c.walls)
    if (wall.pushes() && wall.repulsion_range && *wall.repulsion_range > 1.0001 * half)
      warnings.push_back(
          problem_of(c, "wall." + wall.name + ".repulsion_range",
                     fmt::format("is more than half the spacing, {:.4g} m, where the first "
                                 "particles stand: the wall pushes at the start",
                                 half)));
  Point const anchor = lattice_anchor(c);
  auto const sides = mirror_sides(c);
  for (std::size_t side = 0; side < side_names.size(); ++side) {
    auto const wall = sides[side / 2][side % 2];
    if (!wall) continue;
    double const plane = side % 2 == 0 ? c.domain.min[side / 2] : c.domain.max[side / 2];
    double const layers = (plane - anchor[side / 2]) / c.numerics.spacing;
    if (std::abs(layers - std::round(layers)) < 1e-6) continue;
    warnings.push_back(problem_of(
        c, "wall." + c.walls[*wall].name + ".method",
        fmt::format("puts the mirror {} {:.6g} spacings from the lattice's corner: with a whole "
                    "number the first particles stand half a spacing from it",
                    side_names[side], layers)));
  }
}

}  // namespace moraine
