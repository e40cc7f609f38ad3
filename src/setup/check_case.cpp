#include "setup/check_case.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include "base/input_error.hpp"
#include "setup/check_absorbing.hpp"
#include "setup/check_burn.hpp"
#include "setup/check_compaction.hpp"
#include "setup/check_motion.hpp"
#include "setup/check_options.hpp"
#include "setup/check_probe.hpp"
#include "setup/check_reference.hpp"
#include "setup/check_region.hpp"
#include "setup/check_spacing.hpp"
#include "setup/check_stages.hpp"
#include "setup/check_strength.hpp"
#include "setup/check_walls.hpp"
#include "setup/geometry.hpp"
#include "setup/lattice.hpp"
#include "setup/mirror_walls.hpp"
#include "setup/parameter.hpp"

namespace moraine {
namespace {

class CaseCheck {
 public:
  CaseCheck(Case& c, ItemKeys const& keys, Source& source)
      : case_(c), keys_(keys), source_(source) {}

  void run() {
    check_names(case_.regions, keys_.regions);
    check_names(case_.walls, keys_.walls);
    check_names(case_.gauges, keys_.gauges);
    check_names(case_.stages, keys_.stages);
    check_names(case_.references, keys_.references);
    check_start();
    if (case_.regions.empty() && keys_.regions.empty() && case_.start.run.empty() &&
        !source_.has_problem("region") && !source_.has_problem("start.run"))
      source_.report_key("region", {}, "is missing: a case needs at least one [[region]]",
                         "or a run to start from, start.run");
    if (case_.materials.size() > largest_material_count)
      source_.report_key("material", {},
                         fmt::format("has {} entries; {} are possible", case_.materials.size(),
                                     largest_material_count));
    for (MaterialSpec& material : case_.materials) {
      check_burn(material, "material." + material.name + '.', source_);
      check_strength(material, "material." + material.name + '.', source_);
      check_compaction(material, "material." + material.name + '.', source_);
    }
    for (std::size_t i = 0; i < case_.regions.size(); ++i)
      check_region(case_.regions[i], keys_.regions[i] + '.');
    for (std::size_t i = 0; i < case_.walls.size(); ++i) {
      std::string_view const form =
          case_.walls[i].form == WallForm::container ? ".container" : ".solid";
      check_box(case_.walls[i].box, keys_.walls[i] + std::string(form));
      check_motion(case_.walls[i], keys_.walls[i] + ".motion.", case_, source_);
    }
    for (std::size_t i = 0; i < case_.gauges.size(); ++i)
      if (case_.gauges[i].kind == GaugeKind::front)
        check_material(case_.gauges[i].material, keys_.gauges[i] + ".material");
      else
        check_probe(case_, case_.gauges[i], keys_.gauges[i], source_);
    for (std::size_t i = 0; i < case_.references.size(); ++i)
      check_reference(case_, case_.references[i], keys_.references[i], source_);
    check_stages(case_, keys_.stages, source_);
    check_options(case_, source_);
    check_absorbing(case_, source_);
    check_wall_methods(case_, keys_.walls, keys_.stages, source_);
    check_domain();
    check_spacings(case_, keys_.regions, source_);
  }

 private:
  static constexpr std::size_t largest_material_count = 255;  // one id means "no material"

  // From here on the path counts from any folder; whether something is there is seen when it is
  // read (output/checkpoint/start_reader.hpp).
  void check_start() {
    if (!source_.good("start.run")) return;
    std::filesystem::path path = case_.start.run;
    if (path.is_relative()) path = std::filesystem::path(case_.file).parent_path() / path;
    std::error_code ignored;
    case_.start.run = std::filesystem::absolute(path, ignored).lexically_normal().string();
  }

  template <class Spec>
  void check_names(std::vector<Spec> const& specs, std::vector<std::string> const& keys) {
    std::set<std::string_view> names;
    for (std::size_t i = 0; i < specs.size(); ++i)
      if (!specs[i].name.empty() && !names.insert(specs[i].name).second)
        source_.report_value(keys[i] + ".name", "is used twice");
  }

  void check_material(std::string const& name, std::string const& key) {
    if (!source_.good(key)) return;
    std::vector<std::string_view> names;
    for (auto const& material : case_.materials) names.push_back(material.name);
    if (std::find(names.begin(), names.end(), name) == names.end())
      source_.report_value(key, "is not a material of this case", name_hint(name, names));
  }

  void check_region(RegionSpec& region, std::string const& key) {
    if (!region.material.empty()) check_material(region.material, key + "material");
    check_geometry(region, key, case_, source_);
    check_state(region.initial, key);
    check_density(region, key + "density");
  }

  void check_density(RegionSpec const& region, std::string const& key) {
    if (!region.initial.density || !source_.good(key)) return;
    for (MaterialSpec const& material : case_.materials) {
      double const limit = limiting_density(material.eos);
      if (material.name == region.material && *region.initial.density >= limit)
        source_.report_value(
            key, fmt::format("is not below {:.6g} kg/m^3, which no shock in \"{}\" reaches "
                             "(s eta = 1)",
                             limit, material.name));
    }
  }

  void check_state(InitialState const& initial, std::string const& key) {
    bool const level = initial.hydrostatic_level.has_value();
    if (level && initial.pressure)
      source_.report_value(key + "hydrostatic_level", "is given together with pressure",
                           "give one of the two");
    if (level && initial.density)
      source_.report_value(key + "density", "is given together with hydrostatic_level",
                           "leave it out, it is solved for the pressure");
    if (initial.pressure && initial.density && initial.specific_energy)
      source_.report_value(key + "pressure", "is given together with density and specific_energy",
                           "leave out one of the three");
    bool const gravity_known = !source_.has_problem("physics.gravity");
    if (level && gravity_known && length(case_.gravity) == 0.0)
      source_.report_value(key + "hydrostatic_level", "needs gravity", "give physics.gravity");
  }

  bool is_good(std::string const& key) const {
    return source_.good(key + ".min") && source_.good(key + ".max");
  }

  void check_box(Box const& box, std::string const& key) {
    if (!is_good(key)) return;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis)
      if (!(box.min[axis] < box.max[axis]))
        source_.report_value(key + ".max",
                             fmt::format("must be greater than min along {}", axis_names[axis]));
  }

  void check_domain() {
    if (case_.dimension == 0) return;
    bool const given = source_.has("space.domain.min") || source_.has("space.domain.max");
    if (!given) {
      // Without sound parts a default domain would only cause messages that mislead.
      if (!source_.problems().empty()) return;
      auto const domain = default_domain(case_);
      if (!domain)
        return source_.report_key("space.domain", {},
                                  "is missing: no container wall or bounded region sets its size");
      case_.domain = *domain;
    }
    if (given) check_box(case_.domain, "space.domain");
    if (given && !is_good("space.domain")) return;
    end_domain_at_mirrors(case_);
    check_mirror_sides(case_, keys_.walls, source_);
    check_parts();
    check_gauges();
    check_periodic(given);
    check_symmetry(given);
  }

  void check_symmetry(bool given) {
    if (!case_.symmetry.any()) return;
    std::string const key = "space.symmetry";
    if (!given)
      return source_.report_value(key, "needs space.domain, on whose sides the planes lie");
    Point const anchor = lattice_anchor(case_);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t end = 0; end < 2; ++end) {
        if (!case_.symmetry.planes[axis][end]) continue;
        std::string_view const side = side_names[2 * axis + end];
        if (case_.periodic[axis])
          source_.report_value(
              key, fmt::format("makes a plane of {}, but {} is periodic", side, axis_names[axis]));
        if (case_.gravity[axis] != 0.0)
          source_.report_value(
              key, fmt::format("makes a plane of {}, but gravity points across it", side));
        double const plane = end == 0 ? case_.domain.min[axis] : case_.domain.max[axis];
        double const layers = (plane - anchor[axis]) / case_.numerics.spacing;
        bool const known = source_.good("resolution.spacing");
        if (known && std::abs(layers - std::round(layers)) > 1e-6)
          source_.report_value(
              key,
              fmt::format("puts the plane {} {:.6g} spacings from the lattice's corner; a whole "
                          "number is expected, half a spacing from the nearest particles",
                          side, layers));
      }
  }

  void check_parts() {
    for (std::size_t i = 0; i < case_.regions.size(); ++i) check_shape(i);
    for (std::size_t i = 0; i < case_.walls.size(); ++i) {
      bool const container = case_.walls[i].form == WallForm::container;
      check_inside(case_.walls[i].box, keys_.walls[i] + (container ? ".container" : ".solid"));
      check_motion_inside(case_.walls[i], keys_.walls[i] + ".motion.");
    }
  }

  void check_shape(std::size_t i) {
    auto const& region = case_.regions[i];
    std::string const& key = keys_.regions[i];
    if (auto const* box = std::get_if<Box>(&region.shape)) check_inside(*box, key + ".box");
    check_reach(region, key + '.', case_, source_);
  }

  void check_motion_inside(WallSpec const& wall, std::string const& key) {
    if (!wall.motion.motion) return;
    Box const swept = swept_box(wall, case_);
    check_motion_at_planes(wall, swept, key);
    if (is_inside(swept, with_mirror_images(case_.domain, case_), case_.dimension)) return;
    for (auto const* name : {"translation", "rotation", "file"})
      if (source_.has(key + name))
        return source_.report_value(key + name, "moves the wall out of the domain",
                                    "enlarge space.domain");
  }

  /// A plane cuts a wall once, at the start: what meets it must not move across it.
  void check_motion_at_planes(WallSpec const& wall, Box const& swept, std::string const& key) {
    for (std::size_t side = 0; side < side_names.size(); ++side) {
      std::size_t const axis = side / 2;
      if (!is_plane(case_, axis, side % 2)) continue;
      bool const meets = side % 2 == 0 ? swept.min[axis] <= case_.domain.min[axis]
                                       : swept.max[axis] >= case_.domain.max[axis];
      bool const along =
          swept.min[axis] == wall.box.min[axis] && swept.max[axis] == wall.box.max[axis];
      if (!meets || along) continue;
      for (auto const* name : {"translation", "rotation", "file"})
        if (source_.has(key + name))
          return source_.report_value(
              key + name,
              fmt::format("moves the wall across the {} {}",
                          case_.symmetry.planes[axis][side % 2] ? "symmetry plane" : "mirror wall",
                          side_names[side]),
              "compute the whole");
    }
  }

  void check_inside(Box const& box, std::string const& key) {
    if (!is_good(key)) return;
    Box const allowed = with_mirror_images(case_.domain, case_);
    for (auto const& [corner, name] : {std::pair(box.min, ".min"), std::pair(box.max, ".max")})
      if (!is_inside({corner, corner}, allowed, case_.dimension))
        source_.report_value(key + name, "is outside the domain");
  }

  void check_gauges() {
    for (std::size_t i = 0; i < case_.gauges.size(); ++i) {
      auto const& gauge = case_.gauges[i];
      std::string const key = keys_.gauges[i] + ".position";
      bool const at_place = gauge.kind == GaugeKind::point || gauge.kind == GaugeKind::particle;
      if (at_place && source_.good(key) &&
          !is_inside({gauge.position, gauge.position}, case_.domain, case_.dimension))
        source_.report_value(key, "is outside the domain");
      check_probe_places(case_, gauge, keys_.gauges[i], source_);
    }
  }

  // The lattice of particles must continue across the seam; a hexagonal one is fitted to it.
  void check_periodic(bool given) {
    if (!source_.good("resolution.spacing") || case_.lattice == LatticeName::hexagonal) return;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!case_.periodic[axis]) continue;
      double const extent = case_.domain.max[axis] - case_.domain.min[axis];
      double const count = extent / case_.numerics.spacing;
      if (std::abs(count - std::round(count)) < 1e-6) continue;
      std::string const rule = fmt::format(
          "makes the periodic domain {:.6g} spacings long along {}; a whole number is "
          "expected",
          count, axis_names[axis]);
      source_.report_value(given ? "space.domain.max" : "resolution.spacing", rule);
    }
  }

  Case& case_;
  ItemKeys const& keys_;
  Source& source_;
};

}  // namespace

void finish_case(Case& c, ItemKeys const& keys, Source& source) {
  CaseCheck(c, keys, source).run();
}

}  // namespace moraine
