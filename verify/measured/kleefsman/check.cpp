// A dam break on a box, against the measurements of MARIN.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "setup/build_model.hpp"
#include "step/simulation.hpp"
#include "verify/course.hpp"
#include "verify/gauge_table.hpp"
#include "verify/reference_data.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr char const* measurements = "freesurface/test02_kleefsman_exp.csv";
constexpr double fine = 0.05 / 3.0;   // m, the finer spacing
constexpr double box_width = 0.403;   // m
constexpr double box_height = 0.161;  // m
constexpr double pulse_begin = 0.38;  // s, of the first pulse of the pressure
constexpr double pulse_end = 1.0;     // s
std::string const level = " level";   // column of a gauge of this kind

/// What was measured, from the file above: when the pressure or the water first reaches a value,
/// and the integral of the pressure over the first pulse.
struct Arrival {
  char const* gauge;
  double value;  // Pa or m
  double time;   // s
};
constexpr Arrival hit{"P1", 1000.0, 0.3934};
constexpr Arrival water_there[] = {
    {"H3", 0.05, 0.2497}, {"H2", 0.05, 0.4052}, {"H1 bed", 0.05, 0.9321}};
constexpr Arrival second_wave{"H4", 0.15, 2.743};
constexpr double second_wave_after = 2.0;    // s
constexpr double measured_impulse = 2884.0;  // Pa s, of P1

struct DamBreak {
  double spacing = 0.0;  // m
  Table readings;
  double lost = 0.0;   // share of the particles
  double drift = 0.0;  // of the total energy, what was lost included, over that of the column

  Course course(std::string const& name) const { return Course(readings, "time", name); }
};

DamBreak run(Case c, double spacing, double end) {
  c.numerics.spacing = spacing;
  c.time.end = end;
  Simulation simulation(build_model(c));
  auto const particles = static_cast<double>(simulation.particles().range(Kind::fluid).size());
  ConservedSums const before = simulation.sums();
  DamBreak dam{spacing, read_gauges(simulation, c), 0.0, 0.0};
  LostParticles const lost = simulation.lost();
  dam.lost = static_cast<double>(lost.count) / particles;
  dam.drift = (simulation.sums().total_energy() + lost.energy - before.total_energy()) /
              before.potential_energy;
  return dam;
}

/// Distance of the wall particles behind a side of the box, of this length along an axis: they
/// stand evenly between those half a spacing behind the neighbouring sides (walls/dummy_layer.hpp).
double wall_spacing(double length, double spacing) {
  return (length - spacing) / (std::ceil(length / spacing - 0.5) - 1.0);
}

/// Force on a part of the side that is hit, by its area: the force has all that stops the water,
/// the contact with the wall included, which the pressure of the gauge has not. A wall particle
/// stands for spacing^2 in `wet_area`.
Course load(DamBreak const& dam, std::string const& part) {
  auto const& wet = column(dam.readings, part + " wet_area");
  double const places = *std::max_element(wet.begin(), wet.end()) / std::pow(dam.spacing, 2);
  double const area =
      places * wall_spacing(box_width, dam.spacing) * wall_spacing(box_height, dam.spacing);
  std::vector<double> pressure = column(dam.readings, part + " force_x");
  for (double& value : pressure) value /= area;
  return Course(column(dam.readings, "time"), std::move(pressure));
}

std::string at(DamBreak const& dam) { return fmt::format("{:.3g} cm", 100.0 * dam.spacing); }

/// Each number with the finest spacing; the note has those with all.
template <class Number>
CheckResult row(std::string const& what, std::vector<DamBreak> const& dams, Number&& number,
                double reference, double tolerance, std::string const& unit) {
  std::string note;
  for (DamBreak const& dam : dams)
    note += fmt::format("{}{:.4g} at {}", note.empty() ? "" : ", ", number(dam), at(dam));
  return compare("kleefsman: " + what, number(dams.back()), reference, tolerance, unit, note);
}

std::vector<CheckResult> arrivals(std::vector<DamBreak> const& dams, double end) {
  std::vector<CheckResult> results;
  for (Arrival const& water : water_there)
    if (water.time < end)
      results.push_back(row(
          fmt::format("water at {}", water.gauge), dams,
          [&](DamBreak const& dam) { return dam.course(water.gauge + level).arrival(water.value); },
          water.time, 0.02, "s"));
  return results;
}

CheckResult box_is_hit(std::vector<DamBreak> const& dams) {
  return row(
      "the box is hit", dams,
      [](DamBreak const& dam) { return load(dam, hit.gauge).arrival(hit.value); }, hit.time, 0.02,
      "s");
}

/// The wave that has run back from the far wall and over the box, to the column's end of the tank.
CheckResult back_again(DamBreak const& dam) {
  double const time =
      dam.course(second_wave.gauge + level).arrival(second_wave.value, second_wave_after);
  return compare("kleefsman: second wave at H4", time, second_wave.time, 0.2, "s", at(dam));
}

CheckResult impulse(std::vector<DamBreak> const& dams) {
  return row(
      "impulse at P1", dams,
      [](DamBreak const& dam) { return load(dam, "P1").integral(pulse_begin, pulse_end); },
      measured_impulse, 0.1 * measured_impulse, "Pa s");
}

/// The height of the water against the file, where it is.
CheckResult height(DamBreak const& dam, std::string const& gauge, std::string const& measured,
                   double tolerance) {
  std::string const name = "kleefsman: height at " + gauge;
  auto const file = reference_file(measurements);
  if (file.empty()) return skip(name, no_reference_data);
  Course const experiment(read_table_csv(file), "t_s", measured);
  Course const computed = dam.course(gauge + level);
  return at_most(name, 100.0 * rms_difference(computed, experiment, computed.end()), tolerance,
                 "cm",
                 fmt::format("root of the mean square up to {:g} s, {}", computed.end(), at(dam)));
}

std::vector<CheckResult> conservation(DamBreak const& dam) {
  return {at_most("kleefsman: energy", dam.drift, 0.01, "-",
                  "change of the total / potential energy of the column, " + at(dam)),
          at_most("kleefsman: lost", dam.lost, 0.001, "-",
                  "share of the particles that left the tank, " + at(dam))};
}

}  // namespace

std::vector<CheckResult> check_kleefsman(Effort effort) {
  Case const tank = shipped_case("kleefsman");
  double const coarse = tank.numerics.spacing;
  std::vector<CheckResult> results;
  auto const add = [&](std::vector<CheckResult> const& more) {
    results.insert(results.end(), more.begin(), more.end());
  };
  if (effort == Effort::quick) {
    constexpr double end = 0.5;  // s
    std::vector<DamBreak> const dams{run(tank, coarse, end)};
    add(arrivals(dams, end));
    for (char const* const name :
         {"the box is hit", "impulse at P1", "second wave at H4", "height at H4"})
      add({skip(fmt::format("kleefsman: {}", name), "not with --quick: too coarse or too short")});
    add(conservation(dams.back()));
    return results;
  }
  constexpr double end = 1.02;  // s, with the finer spacing
  std::vector<DamBreak> const dams{run(tank, coarse, tank.time.end), run(tank, fine, end)};
  add(arrivals(dams, end));
  add({box_is_hit(dams), impulse(dams), back_again(dams.front()),
       height(dams.front(), "H4", "H4_x2638mm_m", 1.5)});
  add(conservation(dams.front()));
  return results;
}

}  // namespace moraine
