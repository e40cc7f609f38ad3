// A dam break on a box, against the measurements of MARIN.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
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
constexpr char const* page = "verify/measured/kleefsman/README.md";
constexpr double fine = 0.05 / 3.0;  // m, the finer spacing
std::string const level = " level";  // column of a gauge of this kind

/// A face of the box. Along both sides of what is seen of them both faces are alike.
struct Face {
  char const* force;  // column of a gauge on it
  double sign;        // of a force that presses
  double from, to;    // s, of the pulse whose impulse is compared
};
constexpr double box_width = 0.403;   // m, along y
constexpr double box_length = 0.161;  // m, and its height
constexpr Face front{" force_x", 1.0, 0.38, 1.0};
constexpr Face lid{" force_z", -1.0, 1.1, 2.5};

/// What was measured, from the file above: when the water first reaches a height.
struct Arrival {
  char const* gauge;
  double value;  // m
  double time;   // s
};
constexpr Arrival water_there[] = {{"H3", 0.05, 0.2497}, {"H2", 0.05, 0.4052}};
constexpr Arrival behind_box{"H1 bed", 0.05, 0.9321};
constexpr Arrival second_wave{"H4", 0.15, 2.743};
constexpr double second_wave_after = 2.0;  // s

/// Regression bounds of what is not met: 0.047 s at H1, of which runs that differ in nothing but
/// the time step have 0.03 s, and 2.87 cm at H4.
constexpr double worst_behind_box = 0.08;  // s
constexpr double worst_height = 3.2;       // cm
/// 0.028 s at P6 and P8 on the lid, and 10.4 % of the impulse at P5 beside its edge.
constexpr double worst_on_lid = 0.04;       // s
constexpr double worst_beside_edge = 0.13;  // of the impulse
/// 17 % of the impulse at P3 and P4.
constexpr double worst_high_on_front = 0.2;

/// What was measured, from the file: when the pressure first reaches 1 kPa, and its integral over
/// the pulse of the face.
struct PressureGauge {
  char const* name;
  double arrival;  // s
  double impulse;  // Pa s
};
constexpr double pressure_of_arrival = 1000.0;  // Pa
constexpr PressureGauge on_front[] = {
    {"P1", 0.3934, 2884.0}, {"P2", 0.4103, 2508.0}, {"P3", 0.4235, 2353.0}, {"P4", 0.4328, 2016.0}};
constexpr PressureGauge on_lid[] = {
    {"P5", 1.4793, 1759.0}, {"P6", 1.4855, 1729.0}, {"P7", 1.4367, 1798.0}, {"P8", 1.4805, 1739.0}};

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

/// Force on a part of a face, by its area: the force has all that stops the water, the contact with
/// the wall included, which the pressure of the gauge has not. A wall particle stands for spacing^2
/// in `wet_area`.
Course load(DamBreak const& dam, std::string const& part, Face const& face) {
  auto const& wet = column(dam.readings, part + " wet_area");
  double const places = *std::max_element(wet.begin(), wet.end()) / std::pow(dam.spacing, 2);
  double const area =
      places * wall_spacing(box_width, dam.spacing) * wall_spacing(box_length, dam.spacing);
  std::vector<double> pressure = column(dam.readings, part + face.force);
  for (double& value : pressure) value *= face.sign / area;
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

CheckResult arrival(Arrival const& water, std::vector<DamBreak> const& dams) {
  return row(
      fmt::format("water at {}", water.gauge), dams,
      [&](DamBreak const& dam) { return dam.course(water.gauge + level).arrival(water.value); },
      water.time, 0.02, "s");
}

std::string hit_row(PressureGauge const& gauge) { return fmt::format("{} is hit", gauge.name); }
std::string impulse_row(PressureGauge const& gauge) {
  return fmt::format("impulse at {}", gauge.name);
}

/// When the water arrives at each gauge of a face, and with what impulse: two rows each.
std::vector<CheckResult> pressures(std::span<PressureGauge const> gauges, Face const& face,
                                   std::vector<DamBreak> const& dams) {
  std::vector<CheckResult> results;
  for (PressureGauge const& gauge : gauges) {
    results.push_back(row(
        hit_row(gauge), dams,
        [&](DamBreak const& dam) {
          return load(dam, gauge.name, face).arrival(pressure_of_arrival);
        },
        gauge.arrival, 0.02, "s"));
    results.push_back(row(
        impulse_row(gauge), dams,
        [&](DamBreak const& dam) {
          return load(dam, gauge.name, face).integral(face.from, face.to);
        },
        gauge.impulse, 0.1 * gauge.impulse, "Pa s"));
  }
  return results;
}

/// The front; the page says of the impulses at P3 and P4 what is known.
std::vector<CheckResult> pressures_on_front(std::vector<DamBreak> const& dams) {
  std::vector<CheckResult> results = pressures(on_front, front, dams);
  for (std::size_t const gauge : {2U, 3U}) {
    CheckResult& impulse = results[2 * gauge + 1];
    impulse = explained(impulse, worst_high_on_front * on_front[gauge].impulse, page);
  }
  return results;
}

/// The rows of the lid that the page explains: all times, and the impulse beside the edge.
std::vector<CheckResult> pressures_on_lid(std::vector<DamBreak> const& dams) {
  std::vector<CheckResult> results = pressures(on_lid, lid, dams);
  for (std::size_t k = 0; k < results.size(); k += 2)
    results[k] = explained(results[k], worst_on_lid, page);
  results[1] = explained(results[1], worst_beside_edge * on_lid[0].impulse, page);
  return results;
}

/// The wave that has run back from the far wall and over the box, to the column's end of the tank.
CheckResult back_again(DamBreak const& dam) {
  double const time =
      dam.course(second_wave.gauge + level).arrival(second_wave.value, second_wave_after);
  return compare("kleefsman: second wave at H4", time, second_wave.time, 0.2, "s", at(dam));
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

/// The rows that a short run at the coarse spacing has not.
std::vector<CheckResult> skipped() {
  std::vector<std::string> names{fmt::format("water at {}", behind_box.gauge), "second wave at H4",
                                 "height at H4"};
  for (auto const& gauges : {std::span(on_front), std::span(on_lid)})
    for (PressureGauge const& gauge : gauges) {
      names.push_back(hit_row(gauge));
      names.push_back(impulse_row(gauge));
    }
  std::vector<CheckResult> results;
  for (std::string const& name : names)
    results.push_back(
        skip(fmt::format("kleefsman: {}", name), "not with --quick: too coarse or too short"));
  return results;
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
    for (Arrival const& water : water_there) add({arrival(water, dams)});
    add(skipped());
    add(conservation(dams.back()));
    return results;
  }
  constexpr double end = 1.02;  // s, with the finer spacing
  std::vector<DamBreak> const whole{run(tank, coarse, tank.time.end)};
  std::vector<DamBreak> const dams{whole.front(), run(tank, fine, end)};
  for (Arrival const& water : water_there) add({arrival(water, dams)});
  add({explained(arrival(behind_box, dams), worst_behind_box, page)});
  add(pressures_on_front(dams));
  add(pressures_on_lid(whole));
  add({back_again(whole.front()),
       explained(height(whole.front(), "H4", "H4_x2638mm_m", 1.5), worst_height, page)});
  add(conservation(whole.front()));
  return results;
}

}  // namespace moraine
