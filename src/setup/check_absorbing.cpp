#include "setup/check_absorbing.hpp"

#include <fmt/format.h>

#include "setup/parameter.hpp"

namespace moraine {

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
