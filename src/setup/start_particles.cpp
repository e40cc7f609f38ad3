#include "setup/start_particles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "setup/territory.hpp"
#include "setup/used_case.hpp"
#include "smoothing/kernel_names.hpp"
#include "store/place.hpp"

namespace moraine {
namespace {

// Whether a point lies in the box of a wall, grown on its sides, of a container on its closed ones.
bool lies_in(WallSpec const& wall, Point const& point, int dimension, double growth) {
  bool const container = wall.form == WallForm::container;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
    double const below = container && wall.open[axis][0] ? 0.0 : growth;
    double const above = container && wall.open[axis][1] ? 0.0 : growth;
    if (point[axis] < wall.box.min[axis] - below || point[axis] > wall.box.max[axis] + above)
      return false;
  }
  return true;
}

/// Widest spacing [m] that the particles began with: from mass and reference density.
double widest_spacing(Case const& c) {
  ParticleStore const& store = *c.start.particles;
  double widest = 0.0;
  for (std::size_t i : kept_start_particles(c)) {
    auto const& eos = c.materials[start_material(c, store.material()[i])].eos;
    widest = std::max(widest, store.scalar(Field::mass)[i] / reference_density(eos));
  }
  return std::pow(widest, 1.0 / c.dimension);
}

class StartCheck {
 public:
  explicit StartCheck(Case const& c) : case_(c), store_(*c.start.particles) {}

  std::vector<InputProblem> run() {
    StartInfo const& info = case_.start.info;
    if (info.dimension != case_.dimension) {
      report("space.dimension",
             fmt::format("differs from the dimension of the run that the case starts from, {}",
                         info.dimension));
      return std::move(problems_);
    }
    // "2 cm" and 0.02 are one spacing.
    if (std::abs(info.spacing - case_.numerics.spacing) > 1e-12 * info.spacing)
      report("resolution.spacing",
             fmt::format("differs from the spacing of the run that the case starts from, {} m",
                         info.spacing));
    check_materials();
    check_places("outside the domain", [&](Point const& place) { return outside(place); });
    check_places("inside a wall", [&](Point const& place) { return in_wall(place); });
    if (problems_.empty() && kept_start_particles(case_).empty())
      report("start.run", "has no particle that stays: regions of this case fill all their places",
             "leave out the regions that the other run began with");
    return std::move(problems_);
  }

 private:
  void report(std::string const& key, std::string rule, std::string hint = {}) {
    problems_.push_back(problem_of(case_, key, std::move(rule), std::move(hint)));
  }

  void check_materials() {
    std::vector<std::string_view> names;
    for (MaterialSpec const& material : case_.materials) names.push_back(material.name);
    Range const fluid = store_.range(Kind::fluid);
    std::set<MaterialId> used(store_.material().begin(),
                              store_.material().begin() + static_cast<std::ptrdiff_t>(fluid.end));
    for (MaterialId const id : used) {
      std::string const& name = case_.start.info.materials.at(id).name;
      if (std::find(names.begin(), names.end(), name) == names.end())
        report("start.run",
               fmt::format("holds particles of the material \"{}\", which this case does not have",
                           name),
               name_hint(name, names));
    }
  }

  bool outside(Point const& place) const {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
      if (!case_.periodic[axis] &&
          (place[axis] < case_.domain.min[axis] || place[axis] > case_.domain.max[axis]))
        return true;
    return false;
  }

  // A container is as thick as its particles reach; what was thrown over an open side may lie
  // beyond it.
  bool in_wall(Point const& place) const {
    double const depth = 0.25 * case_.numerics.spacing;
    double const thickness = kernel_support * case_.numerics.largest_smoothing_length();
    auto const any = [&](WallForm form, double growth) {
      return std::any_of(case_.walls.begin(), case_.walls.end(), [&](WallSpec const& wall) {
        return wall.form == form && lies_in(wall, place, case_.dimension, growth);
      });
    };
    if (any(WallForm::solid, -depth)) return true;
    return any(WallForm::container, thickness) && !any(WallForm::container, depth);
  }

  template <class Wrong>
  void check_places(std::string_view where, Wrong wrong) {
    std::size_t count = 0;
    Point first{};
    for (std::size_t i = 0; i < store_.range(Kind::fluid).end; ++i) {
      Point const place = place_of(store_, i);
      if (!wrong(place)) continue;
      if (count++ == 0) first = place;
    }
    if (count == 0) return;
    std::string text;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
      text += fmt::format("{}{:.4g}", axis == 0 ? "" : ", ", first[axis]);
    report("start.run", fmt::format("has {} particle{} {}, the first at ({}) m", count,
                                    count == 1 ? "" : "s", where, text));
  }

  Case const& case_;
  ParticleStore const& store_;
  std::vector<InputProblem> problems_;
};

// The first line of each text that the other does not have in its place.
std::pair<std::string, std::string> first_difference(std::string const& a, std::string const& b) {
  std::istringstream in_a(a), in_b(b);
  std::string line_a, line_b;
  while (true) {
    bool const more_a = static_cast<bool>(std::getline(in_a, line_a));
    bool const more_b = static_cast<bool>(std::getline(in_b, line_b));
    if (!more_a) line_a.clear();
    if (!more_b) line_b.clear();
    if (line_a != line_b || (!more_a && !more_b)) return {line_a, line_b};
  }
}

}  // namespace

std::vector<std::size_t> kept_start_particles(Case const& c) {
  std::vector<std::size_t> kept;
  if (c.start.run.empty()) return kept;
  if (!c.start.particles)
    throw std::invalid_argument("the state that the case starts from has not been read");
  Territory const territory(c);
  for (std::size_t i = 0; i < c.start.particles->range(Kind::fluid).end; ++i)
    if (!territory.owner(place_of(*c.start.particles, i))) kept.push_back(i);
  return kept;
}

MaterialId start_material(Case const& c, std::size_t other) {
  std::string const& name = c.start.info.materials.at(other).name;
  auto const found = std::find_if(c.materials.begin(), c.materials.end(),
                                  [&](MaterialSpec const& m) { return m.name == name; });
  return static_cast<MaterialId>(found - c.materials.begin());
}

bool start_knows_compaction(Case const& c, std::size_t other) {
  static std::string const line = fmt::format("eos = \"{}\"\n", PAlpha::name);
  return c.start.info.materials.at(other).constants.find(line) != std::string::npos;
}

std::vector<InputProblem> start_problems(Case const& c) { return StartCheck(c).run(); }

void add_start_warnings(Case const& c, std::vector<InputProblem>& warnings) {
  if (c.start.run.empty()) return;
  StartInfo const& info = c.start.info;
  if (info.time < info.end)
    warnings.push_back(problem_of(
        c, "start.run",
        fmt::format("had not reached its end: the state is that of {:.6g} s, the end {:.6g} s",
                    info.time, info.end)));
  std::size_t const all = c.start.particles->range(Kind::fluid).size();
  if (std::size_t const kept = kept_start_particles(c).size(); 2 * kept < all)
    warnings.push_back(problem_of(
        c, "start.run",
        fmt::format("loses {} of its {} particles to regions of this case", all - kept, all)));
  double const h = c.numerics.smoothing_length();
  if (double const spacing = widest_spacing(c); h < 0.8 * spacing)
    warnings.push_back(problem_of(
        c, "resolution.smoothing_factor",
        fmt::format("makes the smoothing length {:.4g} m, {:.2g} of the widest spacing, {:.4g} m, "
                    "that comes from the other run",
                    h, h / spacing, spacing),
        "particles would hardly feel their neighbours: raise it"));
  for (RegionSpec const& region : c.regions)
    if (region.initial.lithostatic_load)
      warnings.push_back(
          problem_of(c, "region." + region.name + ".lithostatic_load",
                     "counts the weight of the regions above alone, not that of particles which "
                     "come from the other run"));
  for (MaterialSpec const& material : c.materials)
    for (StartMaterial const& other : info.materials) {
      if (other.name != material.name) continue;
      auto const [there, here] = first_difference(other.constants, material_constants(c, material));
      if (there != here)
        warnings.push_back(problem_of(
            c, "material." + material.name,
            fmt::format("is another one in the run that the case starts from: \"{}\" there, "
                        "\"{}\" here; its particles keep density and energy, not pressure",
                        there, here)));
    }
}

}  // namespace moraine
