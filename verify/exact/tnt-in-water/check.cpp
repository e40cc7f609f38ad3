// What must be true of a charge of TNT in water, whatever the resolution.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "exact/hugoniot.hpp"
#include "exact/riemann.hpp"
#include "probes/point_probe.hpp"
#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double half_charge = 0.05;  // m

/// Speed of the shock [m/s] that the charge's plane face sends into the water at the first instant.
/// Later and sideways the charge can only push less: no shock of this case is faster.
double first_shock_speed(Jwl const& products, WaterPolynomial const& water) {
  return RiemannProblem({products, products.reference_density, 0.0, products.reference_energy},
                        {water, water.reference_density, 0.0, water.reference_energy})
      .right_wave()
      ->head;
}

/// The readings of one gauge until its first peak is over.
class Gauge {
 public:
  Gauge(double distance, double end) : distance_(distance), end_(end) {}

  void read(Simulation const& simulation, Numerics const& numerics) {
    if (simulation.time() > end_) return;
    readings_.emplace_back(simulation.time(),
                           probe_point(simulation.particles(), numerics.kernel,
                                       numerics.smoothing_length(), {distance_, 0.0, 0.0})
                               .pressure);
  }

  double peak() const {
    double most = 0.0;
    for (auto const& [time, pressure] : readings_) most = std::max(most, pressure);
    return most;
  }

  /// When the pressure passes half of its peak [s].
  double arrival() const {
    for (auto const& [time, pressure] : readings_)
      if (2.0 * pressure > peak()) return time;
    return std::numeric_limits<double>::quiet_NaN();
  }

  double distance() const { return distance_; }

 private:
  double distance_;
  double end_;
  std::vector<std::pair<double, double>> readings_;
};

/// Position of the particle at each place of the lattice that the run began with.
std::vector<std::array<double, 2>> by_place(ParticleStore const& store, std::size_t count) {
  std::vector<std::array<double, 2>> at(count);
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    at[store.id()[i]] = {store.component(Field::position, 0)[i],
                         store.component(Field::position, 1)[i]};
  return at;
}

/// Largest difference of a coordinate between a particle and its images in the axes and in the
/// diagonal [m]; a particle that was lost counts as being in the centre.
double asymmetry(ParticleStore const& store, std::size_t count) {
  auto const at = by_place(store, count);
  auto const side = static_cast<std::size_t>(std::lround(std::sqrt(at.size())));
  double worst = 0.0;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      auto const& here = at[y * side + x];
      auto const& left = at[y * side + side - 1 - x];
      auto const& below = at[(side - 1 - y) * side + x];
      auto const& across = at[x * side + y];
      worst = std::max({worst, std::fabs(here[0] + left[0]), std::fabs(here[1] - left[1]),
                        std::fabs(here[0] - below[0]), std::fabs(here[1] + below[1]),
                        std::fabs(here[0] - across[1]), std::fabs(here[1] - across[0])});
    }
  return worst;
}

/// Largest distance of a particle of a material to its nearest neighbour [m].
double loneliest(ParticleStore const& store, MaterialId material) {
  auto const x = store.component(Field::position, 0);
  auto const y = store.component(Field::position, 1);
  std::size_t const count = store.range(Kind::fluid).size();
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    if (store.material()[i] != material) continue;
    double least2 = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < count; ++j)
      if (j != i) least2 = std::min(least2, std::pow(x[i] - x[j], 2) + std::pow(y[i] - y[j], 2));
    most = std::max(most, least2);
  }
  return std::sqrt(most);
}

/// Sum over the fluid of mass times speed [kg m/s].
double sum_of_momenta(ParticleStore const& store) {
  double sum = 0.0;
  for (std::size_t i = 0; i < store.range(Kind::fluid).size(); ++i)
    sum += store.scalar(Field::mass)[i] * std::hypot(store.component(Field::velocity, 0)[i],
                                                     store.component(Field::velocity, 1)[i]);
  return sum;
}

/// The momentum of a charge that is symmetric about nothing, in a box that its shock has reached:
/// change less the impulse of the walls. The charge of the case is symmetric about its centre,
/// where the sum vanishes whatever the forces are.
CheckResult momentum(Case blast) {
  blast.time.end = 200e-6;
  double const a = half_charge;
  blast.regions.push_back(blast.regions.back());
  blast.regions.back().name = "arm";
  blast.regions.back().shape = Box{{a, -a, 0.0}, {a + 0.06, -a + 0.03, 0.0}};
  Simulation simulation(build_model(blast));
  while (simulation.running()) simulation.advance();
  ConservedSums const sums = simulation.sums();
  double const by_walls = std::hypot(sums.wall_impulse[0], sums.wall_impulse[1]);
  double const all = sum_of_momenta(simulation.particles());
  return at_most(
      "tnt-in-water: momentum",
      std::hypot(sums.momentum[0] - sums.wall_impulse[0], sums.momentum[1] - sums.wall_impulse[1]) /
          all,
      1e-12, "-",
      fmt::format("an L of TNT after 200 us: of the fluid less the impulse of the walls "
                  "({:.2g}) / sum of m |v|",
                  by_walls / all));
}

/// The negative control: with h of 1.2 spacings that does not follow the density, gas loses its
/// neighbours as it expands. `moraine check` says so before (setup/smoothing_warnings.cpp).
CheckResult comes_apart(Case blast, MaterialId gas) {
  blast.numerics.smoothing_factor = 1.2;
  double const support = kernel_support * blast.numerics.smoothing_length();
  Simulation simulation(build_model(blast));
  double apart = 0.0;
  for (int samples = 0; simulation.running();) {
    simulation.advance();
    if (simulation.time() < 20e-6 * samples) continue;
    ++samples;
    apart = std::max(apart, loneliest(simulation.particles(), gas));
  }
  return compare("tnt-in-water: gas with h of 1.2 spacings comes apart",
                 apart > support ? 1.0 : 0.0, 1.0, 0.0, "-",
                 fmt::format("its nearest neighbour is {:.3g} supports away (negative control)",
                             apart / support));
}

/// A shock between the fastest that the charge can make and a sound wave.
CheckResult arrival(Gauge const& gauge, double fastest, double slowest) {
  double const path = gauge.distance() - half_charge;
  double const middle = 0.5 * (path / fastest + path / slowest);
  return compare(fmt::format("tnt-in-water: arrival at {:g} cm", 100.0 * gauge.distance()),
                 1e6 * gauge.arrival(), 1e6 * middle, 1e6 * (path / slowest - middle), "us",
                 fmt::format("half the peak; between {:.0f} m/s, the strongest shock, and {:.0f} "
                             "m/s, sound",
                             fastest, slowest));
}

/// Speed of a shock in the water that has pressure `p` [Pa] behind it.
double shock_speed(WaterPolynomial const& water, double p) {
  return shock_to_pressure(water, water.reference_density, water.reference_energy, p)
      .behind.shock_speed;
}

/// A shock that dies away between two gauges: its mean speed lies between those of the two peaks.
CheckResult mean_speed(Gauge const& near, Gauge const& far, WaterPolynomial const& water) {
  double const fast = shock_speed(water, near.peak());
  double const slow = shock_speed(water, far.peak());
  return compare("tnt-in-water: speed from 15 to 30 cm",
                 (far.distance() - near.distance()) / (far.arrival() - near.arrival()),
                 0.5 * (fast + slow), 0.5 * (fast - slow), "m/s",
                 fmt::format("jump conditions at the peaks of {:.2f} and {:.2f} GPa",
                             1e-9 * near.peak(), 1e-9 * far.peak()));
}

}  // namespace

std::vector<CheckResult> check_tnt_in_water(Effort effort) {
  Case blast = shipped_case("tnt-in-water");
  blast.numerics.precision = Precision::full;
  if (effort == Effort::quick) blast.time.end = 160e-6;
  auto const gas =
      static_cast<MaterialId>(std::holds_alternative<Jwl>(blast.materials[0].eos) ? 0 : 1);
  Jwl const products = std::get<Jwl>(blast.materials[gas].eos);
  WaterPolynomial const water = std::get<WaterPolynomial>(blast.materials[1U - gas].eos);
  double const support = kernel_support * blast.numerics.smoothing_length();
  Simulation simulation(build_model(blast));
  ParticleStore const& store = simulation.particles();
  std::size_t const count = store.range(Kind::fluid).size();
  double const energy = simulation.sums().total_energy();
  double released = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    if (store.material()[i] == gas)
      released += store.scalar(Field::mass)[i] * products.reference_energy;
  Gauge near(0.15, 90e-6), far(0.30, 160e-6);  // before what the walls send back
  double drift = 0.0, apart = 0.0;
  int samples = 0;
  while (simulation.running()) {
    simulation.advance();
    near.read(simulation, blast.numerics);
    far.read(simulation, blast.numerics);
    drift = std::max(drift, std::fabs(simulation.sums().total_energy() - energy));
    if (simulation.time() < 20e-6 * samples) continue;
    ++samples;
    apart = std::max(apart, loneliest(store, gas));
  }
  double const fastest = first_shock_speed(products, water);
  double const slowest = water.sound_speed(water.reference_density, water.reference_energy);
  return {at_most("tnt-in-water: energy", drift / released, 0.01, "-",
                  "largest change of the total at any time / energy of the charge"),
          at_most("tnt-in-water: symmetry", asymmetry(store, count) / blast.numerics.spacing, 1e-6,
                  "spacings", "largest difference from an image in the axes or the diagonal"),
          momentum(blast),
          compare("tnt-in-water: particles", static_cast<double>(store.range(Kind::fluid).size()),
                  static_cast<double>(count), 0.0, "-", "none leaves the box"),
          at_most("tnt-in-water: gas", apart / support, 1.0, "supports",
                  "largest distance of a gas particle to its nearest neighbour"),
          comes_apart(blast, gas),
          arrival(near, fastest, slowest),
          arrival(far, fastest, slowest),
          mean_speed(near, far, water)};
}

}  // namespace moraine
