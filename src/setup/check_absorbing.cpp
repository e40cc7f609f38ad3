#include "setup/check_absorbing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <variant>

#include "setup/parameter.hpp"
#include "store/place.hpp"

namespace moraine {
namespace {

/// Shares of the particles of each material that begin in a layer.
std::vector<double> shares_in_layers(Model const& model) {
  ParticleStore const& store = model.particles;
  std::vector<double> inside(model.materials.size()), all(model.materials.size());
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i) {
    ++all[store.material()[i]];
    if (model.absorbing.fading(place_of(store, i)) > 0.0) ++inside[store.material()[i]];
  }
  for (std::size_t m = 0; m < all.size(); ++m) inside[m] /= std::max(all[m], 1.0);
  return inside;
}

}  // namespace

void add_absorbing_warnings(Case const& c, Model const& model,
                            std::vector<InputProblem>& warnings) {
  if (!model.absorbing.any()) return;
  for (GaugeSpec const& gauge : c.gauges)
    if (gauge.kind == GaugeKind::point && model.absorbing.fading(gauge.position) > 0.0)
      warnings.push_back(problem_of(c, "gauge." + gauge.name + ".position",
                                    "lies in an absorbing layer, where readings mean nothing"));
  auto const shares = shares_in_layers(model);
  for (std::size_t m = 0; m < shares.size(); ++m) {
    std::string const& name = c.materials[m].name;
    bool const explosive = std::holds_alternative<Jwl>(c.materials[m].eos);
    if (explosive && shares[m] > 0.0)
      warnings.push_back(problem_of(c, "space.absorbing.thickness",
                                    "reaches " + name + ": layers swallow what goes off there"));
    else if (shares[m] > 0.75)
      warnings.push_back(
          problem_of(c, "space.absorbing.thickness",
                     fmt::format("makes layers of {:.0f} % of {}", 100.0 * shares[m], name),
                     "make them thinner, or the domain larger"));
  }
}

void check_absorbing(Case const& c, Source& source) {
  std::string const sides = "space.absorbing.sides";
  if (!source.has(sides) || !source.good(sides)) return;
  if (!c.start.run.empty())
    source.report_value(sides, "is given with start.run, which does not say where layers were",
                        "let stages follow each other in one case instead");
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t end = 0; end < 2; ++end) {
      if (!c.absorbing.sides[axis][end]) continue;
      std::string_view const name = side_names[2 * axis + end];
      if (axis >= static_cast<std::size_t>(c.dimension))
        source.report_value(sides, fmt::format("has the side {} in {}D", name, c.dimension));
      else if (c.periodic[axis])
        source.report_value(sides, fmt::format("has the side {} of a periodic axis", name));
      else if (c.symmetry.planes[axis][end])
        source.report_value(sides, fmt::format("has the side {}, a symmetry plane", name));
      else if (c.absorbing.thickness < 4.0 * c.numerics.spacing &&
               source.good("space.absorbing.thickness"))
        source.report_value(
            "space.absorbing.thickness",
            fmt::format("is less than four spacings, {:.4g} m", 4.0 * c.numerics.spacing));
    }
}

}  // namespace moraine
