#include "setup/check_spacing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/input_error.hpp"
#include "setup/parameter.hpp"
#include "setup/region_lattice.hpp"

namespace moraine {
namespace {

// The limits of resolution.smoothing_factor, which hold for every spacing.
constexpr double least_factor = 0.8;
constexpr double largest_factor = 8.0;

class SpacingCheck {
 public:
  SpacingCheck(Case const& c, std::vector<std::string> const& keys, Source& source)
      : case_(c), keys_(keys), source_(source) {}

  void run() {
    for (std::size_t i = 0; i < case_.regions.size(); ++i) check_partner(i);
    bool const sound = source_.problems().empty();
    if (source_.good("resolution.spacing") && !source_.has_problem("resolution.smoothing_factor"))
      for (std::size_t i = 0; i < case_.regions.size(); ++i)
        if (case_.regions[i].spacing) check_smoothing(i, *case_.regions[i].spacing);
    // Spacings from masses and places of lattices follow from much else: states, materials, walls.
    if (!sound) return;
    auto const lattices = lattices_of_regions(case_);
    for (std::size_t i = 0; i < case_.regions.size(); ++i) {
      if (!case_.regions[i].equal_mass_with.empty()) check_smoothing(i, lattices[i].spacing);
      if (has_own_lattice(case_.regions[i])) check_period(i, lattices[i]);
    }
  }

 private:
  std::string key(std::size_t i) const {
    return keys_[i] + (case_.regions[i].spacing ? ".spacing" : ".equal_mass_with");
  }

  std::optional<std::size_t> index_of(std::string const& name) const {
    for (std::size_t i = 0; i < case_.regions.size(); ++i)
      if (case_.regions[i].name == name) return i;
    return std::nullopt;
  }

  void check_partner(std::size_t i) {
    RegionSpec const& region = case_.regions[i];
    std::string const own = keys_[i] + ".equal_mass_with";
    if (!source_.good(own)) return;
    if (source_.has(keys_[i] + ".spacing"))
      return source_.report_value(own, "is given together with spacing", "give one of the two");
    auto const other = index_of(region.equal_mass_with);
    if (!other) {
      std::vector<std::string_view> names;
      for (auto const& each : case_.regions)
        if (each.name != region.name && !each.name.empty()) names.push_back(each.name);
      return source_.report_value(own, "is not a region of this case",
                                  name_hint(region.equal_mass_with, names));
    }
    for (std::size_t const each : {i, *other})
      if (!case_.regions[each].layers.materials.empty())
        return source_.report_value(
            own,
            fmt::format("needs one density in both regions; \"{}\" has layers",
                        case_.regions[each].name),
            "give spacing");
    std::optional<std::size_t> next = other;
    for (std::size_t passed = 0; next && passed < case_.regions.size(); ++passed) {
      if (next == i)
        return source_.report_value(own, "leads back to this region", "give one of them a spacing");
      std::string const& name = case_.regions[*next].equal_mass_with;
      next = name.empty() ? std::nullopt : index_of(name);
    }
  }

  // "2 cm" is the value; of equal masses the spacing is not in the file.
  std::string made(std::size_t i, double spacing) const {
    return case_.regions[i].spacing ? std::string("makes")
                                    : fmt::format("makes a spacing of {:.4g} m, and", spacing);
  }

  void check_smoothing(std::size_t i, double spacing) {
    Numerics const& numerics = case_.numerics;
    double const own =
        std::clamp(numerics.smoothing_factor * spacing, numerics.least_smoothing_length(),
                   numerics.largest_smoothing_length());
    double const h = numerics.smoothing.varies() ? own : numerics.smoothing_length();
    double const factor = h / spacing;
    if (factor >= least_factor * (1.0 - 1e-9) && factor <= largest_factor * (1.0 + 1e-9)) return;
    bool const coarse = factor < least_factor;
    source_.report_value(
        key(i),
        fmt::format("{} the smoothing length of the case, {:.4g} m, {:.3g} of its spacings; "
                    "between {} and {} are possible",
                    made(i, spacing), h, factor, least_factor, largest_factor),
        coarse
            ? fmt::format("at most {:.4g} m, or raise resolution.smoothing_factor",
                          h / least_factor)
            : fmt::format("at least {:.4g} m, or refine resolution.spacing", h / largest_factor));
  }

  void check_period(std::size_t i, Lattice const& lattice) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(case_.dimension); ++axis) {
      if (!fills_period(case_, case_.regions[i], axis)) continue;
      double const extent = case_.domain.max[axis] - case_.domain.min[axis];
      double const count = extent / lattice.edge[axis];
      if (std::abs(count - std::round(count)) < 1e-6) continue;
      source_.report_value(
          key(i), fmt::format("{} the periodic domain {:.6g} spacings long along {}; a whole "
                              "number is expected",
                              made(i, lattice.spacing), count, axis_names[axis]));
    }
  }

  Case const& case_;
  std::vector<std::string> const& keys_;
  Source& source_;
};

}  // namespace

void check_spacings(Case const& c, std::vector<std::string> const& keys, Source& source) {
  SpacingCheck(c, keys, source).run();
}

}  // namespace moraine
