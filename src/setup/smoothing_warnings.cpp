#include "setup/smoothing_warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>

#include "setup/parameter.hpp"
#include "setup/region_lattice.hpp"
#include "smoothing/kernel_names.hpp"

namespace moraine {
namespace {

constexpr std::array<double, 3> fewest{4.0, 12.0, 33.0};
constexpr std::array<double, 3> usual{5.0, 21.0, 57.0};
constexpr double most = 4.0;  // times the usual number

/// h in spacings with which products that expand keep neighbours though h is constant; with less
/// they are out of each other's reach soon (cases/tnt-in-water/README.md, measured in 2D).
constexpr double enough_for_products = 2.0;

/// h in spacings at which the nearest neighbours of a lattice stand where the slope of the kernel
/// is steepest, 1/q there; with more they may form pairs. Infinite: they do not, or do anyway.
double inflection_factor(KernelName kernel) {
  switch (kernel) {
    case KernelName::cubic_spline:
    case KernelName::lucy:
      return 1.5;
    case KernelName::liu_quartic:
      return 1.58;
    case KernelName::quartic_spline:
      return 1.81;
    case KernelName::quintic_spline:
      return 1.98;
    case KernelName::gaussian:
      return 2.12;
    default:
      return std::numeric_limits<double>::infinity();
  }
}

class SmoothingWarnings {
 public:
  SmoothingWarnings(Case const& c, std::vector<InputProblem>& warnings)
      : case_(c), warnings_(warnings), axes_(static_cast<std::size_t>(c.dimension)) {}

  void find() {
    look_at_factor();
    auto const lattices = lattices_of_regions(case_);
    for (std::size_t i = 0; i < lattices.size(); ++i)
      if (has_own_lattice(case_.regions[i])) look_at(case_.regions[i], lattices[i]);
    if (case_.numerics.smoothing.varies()) return;
    for (MaterialSpec const& material : case_.materials)
      if (std::holds_alternative<Jwl>(material.eos)) look_at_products(material.name, lattices);
  }

 private:
  void warn(std::string const& key, std::string rule, std::string hint = {}) {
    warnings_.push_back(problem_of(case_, key, std::move(rule), std::move(hint)));
  }

  void look_at_factor() {
    double const factor = case_.numerics.smoothing_factor;
    double const neighbours = neighbours_within(kernel_support * factor, case_.dimension);
    if (neighbours < fewest[axes_ - 1]) {
      warn("resolution.smoothing_factor", fmt::format("gives {}", neighbour_words(neighbours)));
      if (warnings_.back().value.empty()) warnings_.back().value = fmt::format("{}", factor);
    }
    double const steepest = inflection_factor(case_.numerics.kernel);
    if (factor > steepest)
      warn("resolution.smoothing_factor", "puts " + pairing(),
           fmt::format("at most {:.3g}, or the kernel wendland_c2", steepest));
    look_at_kernel();
  }

  /// Of an explosive, by the coarsest lattice that it is filled on; it may come later, by a stage.
  void look_at_products(std::string const& material, std::vector<Lattice> const& lattices) {
    double const h = case_.numerics.smoothing_length();
    double coarsest = 0.0;
    for (std::size_t i = 0; i < lattices.size(); ++i)
      if (is_of(case_.regions[i], material)) coarsest = std::max(coarsest, lattices[i].spacing);
    double const factor = h / (coarsest > 0.0 ? coarsest : case_.numerics.spacing);
    if (factor > enough_for_products * (1.0 - 1e-6)) return;
    warn("resolution.smoothing_factor",
         fmt::format("keeps h at {:.3g} spacings of {} while it expands, and its particles lose "
                     "their neighbours",
                     factor, material),
         "give smoothing = { mode = \"density\" }, or 2 spacings");
    if (warnings_.back().value.empty())
      warnings_.back().value = fmt::format("{}", case_.numerics.smoothing_factor);
  }

  static bool is_of(RegionSpec const& region, std::string const& material) {
    auto const& layers = region.layers.materials;
    return region.material == material ||
           std::find(layers.begin(), layers.end(), material) != layers.end();
  }

  void look_at_kernel() {
    KernelName const kernel = case_.numerics.kernel;
    if (kernel == KernelName::super_gaussian || kernel == KernelName::liu_quartic)
      warn("resolution.kernel", "rises again far outside, where pressure pulls and viscosity cools",
           "for comparison only; take wendland_c2");
    if (kernel == KernelName::dome)
      warn("resolution.kernel",
           "lets the force jump where a neighbour comes or goes: the energy suffers",
           "for comparison only, with time.courant = 0.15");
  }

  std::string neighbour_words(double neighbours) const {
    return fmt::format("about {:.2g} neighbours; {:.0f} are usual in {}D", neighbours,
                       usual[axes_ - 1], axes_);
  }

  void look_at(RegionSpec const& region, Lattice const& lattice) {
    std::string const key =
        "region." + region.name + (region.spacing ? std::string(".spacing") : ".equal_mass_with");
    double const factor = smoothing_at(lattice.spacing) / lattice.spacing;
    double const neighbours = neighbours_within(kernel_support * factor, case_.dimension);
    if (neighbours < fewest[axes_ - 1] || neighbours > most * usual[axes_ - 1])
      warn(key,
           fmt::format("makes a spacing of {:.4g} m and gives {}: h is {:.3g} of these spacings",
                       lattice.spacing, neighbour_words(neighbours), factor),
           neighbours < fewest[axes_ - 1] ? "raise resolution.smoothing_factor"
                                          : "each particle costs as much more");
    if (factor > inflection_factor(case_.numerics.kernel))
      warn(key, fmt::format("makes h {:.3g} of these spacings and puts {}", factor, pairing()),
           "use the kernel wendland_c2");
    if (std::holds_alternative<Box>(region.shape) && region.plus.empty())
      look_at_box(region, lattice, key);
  }

  void look_at_box(RegionSpec const& region, Lattice const& lattice, std::string const& key) {
    auto const box = filled_box(case_, region);
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      double const count = (box->max[axis] - box->min[axis]) / lattice.layer(axis);
      if (std::abs(count - std::round(count)) < 1e-6) continue;
      warn(key,
           fmt::format("makes the box {:.4g} layers long along {}; {:.0f} of them fill it, with "
                       "{:.2g} % {} mass",
                       count, axis_names[axis], std::round(count),
                       100.0 * std::abs(std::round(count) / count - 1.0),
                       std::round(count) > count ? "more" : "less"),
           "a box of a whole number of layers has its exact mass");
    }
  }

  std::string pairing() const {
    return fmt::format(
        "neighbours at rest inside the inflection point of the {}, where they may form pairs",
        info(case_.numerics.kernel).words);
  }

  /// h that a region of this spacing starts with [m].
  double smoothing_at(double spacing) const {
    Numerics const& numerics = case_.numerics;
    if (!numerics.smoothing.varies()) return numerics.smoothing_length();
    return std::clamp(numerics.smoothing_factor * spacing, numerics.least_smoothing_length(),
                      numerics.largest_smoothing_length());
  }

  Case const& case_;
  std::vector<InputProblem>& warnings_;
  std::size_t axes_;
};

}  // namespace

double neighbours_within(double reach, int dimension) {
  if (dimension == 1) return 2.0 * reach;
  if (dimension == 2) return std::numbers::pi * reach * reach;
  return 4.0 / 3.0 * std::numbers::pi * reach * reach * reach;
}

void add_smoothing_warnings(Case const& c, std::vector<InputProblem>& warnings) {
  SmoothingWarnings(c, warnings).find();
}

}  // namespace moraine
