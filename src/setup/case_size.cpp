#include "setup/case_size.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "setup/fill.hpp"
#include "setup/geometry.hpp"
#include "setup/region_lattice.hpp"
#include "setup/smoothing_warnings.hpp"

namespace moraine {
namespace {

// Indices of particles and of their images in lists are 32-bit.
constexpr double most_particles = 2147483647.0;

// Memory of a run per particle, walls included, by dimension: what `moraine bench` measures for
// large tanks (docs/performance.md). In 1D lists are shorter than in 2D.
constexpr std::array bytes_per_particle{300.0, 380.0, 510.0};

// A checkpoint is put together in memory before it is written: measured sizes of files of resting
// liquid. Envelopes (output.arrival_pressure) add 32 bytes.
constexpr std::array checkpoint_bytes_per_particle{94.0, 122.0, 151.0};

double wall_particles(Case const& c, WallSpec const& wall) {
  if (wall.method != WallMethod::dummy) return 0.0;
  double const layers =
      std::ceil(kernel_support * c.numerics.largest_smoothing_length() / c.numerics.spacing - 1e-9);
  auto const axes = static_cast<std::size_t>(c.dimension);
  double sum = 0.0;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    double side = layers;
    for (std::size_t other = 0; other < axes; ++other)
      if (other != axis) side *= (wall.box.max[other] - wall.box.min[other]) / c.numerics.spacing;
    for (bool const open : wall.open[axis]) sum += open ? 0.0 : side;
  }
  return sum;
}

// Beyond the neighbours that particles at the spacing of the case have, those of a finer region
// have more of them in their lists, two bytes each (search/neighbour_list.hpp).
double longer_lists(Case const& c, double spacing) {
  double const h = c.numerics.smoothing_length();
  return 2.0 * std::max(0.0, neighbours_within(kernel_support * h / spacing, c.dimension) -
                                 neighbours_within(kernel_support * c.numerics.smoothing_factor,
                                                   c.dimension));
}

// The key whose spacing makes most particles, and the place of that spacing.
struct Culprit {
  std::string key = "resolution.spacing";
  std::optional<std::size_t> region{};  // with a spacing of its own
  double& spacing(Case& c) const {
    return region ? *c.regions[*region].spacing : c.numerics.spacing;
  }
};

Culprit culprit_of(Case const& c) {
  auto const particles = estimated_by_region(c);
  auto const most = std::max_element(particles.begin(), particles.end());
  Culprit culprit;
  if (most == particles.end()) return culprit;
  auto const i = static_cast<std::size_t>(most - particles.begin());
  if (!c.regions[i].spacing) return culprit;
  culprit.key = "region." + c.regions[i].name + ".spacing";
  culprit.region = i;
  return culprit;
}

// Lattice points between the outermost regions: each is asked for its owner.
double points_to_ask(Case const& c) {
  auto const regions = box_around_regions(c);
  Box const range = regions ? common(c.domain, *regions) : c.domain;
  double points = 1.0;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(c.dimension); ++axis)
    points *= std::max(range.max[axis] - range.min[axis], 0.0) / c.numerics.spacing;
  return points;
}

void check_extent(Case const& c) {
  constexpr double most_points = 10.0 * most_particles;  // minutes
  double const points = points_to_ask(c);
  if (points <= most_points) return;
  throw InputErrors({problem_of(
      c, "resolution.spacing",
      fmt::format("lays about {:.2g} places for particles across the regions; at most {:.2g} are "
                  "possible, filled or not",
                  points, most_points),
      "bring the regions closer together, or take a coarser spacing")});
}

double size_for(Case const& c, Culprit const& culprit, double spacing) {
  Case other = c;
  culprit.spacing(other) = spacing;
  return estimate_size(other).particles();
}

// The finest of the spacings 1, 2 and 5 times a power of ten that gives at most so many particles;
// nothing if none does, because others have too many.
std::optional<double> fitting_spacing(Case c, Culprit const& culprit, double most) {
  double const given = culprit.spacing(c);
  double power = std::pow(10.0, std::floor(std::log10(given)));
  for (int tens = 0; tens < 12; ++tens, power *= 10.0)
    for (double const digit : {1.0, 2.0, 5.0})
      if (digit * power > given && size_for(c, culprit, digit * power) <= most)
        return digit * power;
  return std::nullopt;
}

}  // namespace

CaseSize estimate_size(Case const& c) {
  CaseSize size;
  auto const particles = estimated_by_region(c);
  auto const lattices = lattices_of_regions(c);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    size.fluid += particles[i];
    size.bytes += particles[i] * longer_lists(c, lattices[i].spacing);
  }
  if (c.start.particles)
    size.fluid += static_cast<double>(c.start.particles->range(Kind::fluid).size());
  for (WallSpec const& wall : c.walls) size.walls += wall_particles(c, wall);
  auto const axes = static_cast<std::size_t>(c.dimension - 1);
  double const envelopes = c.output.arrival_pressure ? 32.0 : 0.0;
  bool const burns = std::any_of(c.materials.begin(), c.materials.end(), [](MaterialSpec const& m) {
    return m.burn.kind == BurnKind::programmed;
  });
  double const burning = burns ? 32.0 : 0.0;  // two numbers, here and in a checkpoint
  size.bytes += size.particles() * (bytes_per_particle[axes] + checkpoint_bytes_per_particle[axes] +
                                    envelopes + burning);
  return size;
}

double machine_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void check_size(Case const& c, double memory) {
  CaseSize const size = estimate_size(c);
  bool const countable = size.particles() <= most_particles;
  if (countable && size.bytes <= memory) return check_extent(c);
  double const most = std::min(most_particles, memory / size.bytes * size.particles());
  std::string const limit =
      countable ? fmt::format("this machine has {:.3g} GB", memory / 1e9)
                : fmt::format("at most {:.0f} particles are possible", most_particles);
  Culprit const culprit = culprit_of(c);
  auto const fitting = fitting_spacing(c, culprit, most);
  throw InputErrors({problem_of(
      c, culprit.key,
      fmt::format("makes about {:.2g} particles, which need about {:.3g} GB of memory; {}",
                  size.particles(), size.bytes / 1e9, limit),
      fitting ? fmt::format("a spacing of {:.4g} m fits", *fitting) : std::string())});
}

}  // namespace moraine
