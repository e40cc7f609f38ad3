// Shocks and bubbles under water.
#include <array>
#include <cmath>

#include "blast/pulse.hpp"
#include "blast/sources.hpp"
#include "blast/underwater.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Standing recommended = Standing::recommended, comparison = Standing::comparison;

double radii(Situation const& s) { return charge_radii(s.scaled_distance()); }
double depth_in_radii(Situation const& s) {
  return s.depth / bubble_radius(s.charge_mass, s.depth);
}

constexpr Validity swisdak_range = range_of(
    "p", "MPa",
    [](Situation const& s) { return 1e-6 * swisdak_water_pressure(s.scaled_distance()); }, 3.4,
    138.0);
constexpr Validity zamyshlyaev_range = range_of("R/R_0", "charge radii", radii, 6.0, 240.0);
constexpr Validity deep = range_of("d/a_m", "bubble radii", depth_in_radii, 2.0, unbounded);
constexpr double least_density = 1000.0, most_density = 1030.0;  // kg/m^3, fresh and sea water
constexpr std::string_view zamyshlyaev_source =
    "B. V. Zamyshlyaev, Yu. S. Yakovlev, Dynamic loads in underwater explosion (1967)";
constexpr std::string_view bubble_note =
    "one sphere far from surface and bed; the lower end of the range is the program's choice";

constexpr Relation water(std::string_view name, Measure measure, Standing standing,
                         std::string_view formula, std::string_view source,
                         Validity const& validity, Outcome (*evaluate)(Situation const&)) {
  return {.name = name,
          .topic = Topic::water,
          .measure = measure,
          .standing = standing,
          .formula = formula,
          .source = source,
          .validity = validity,
          .evaluate = evaluate};
}

constexpr Relation bubble(std::string_view name, Measure measure, std::string_view formula,
                          std::string_view source, Outcome (*evaluate)(Situation const&)) {
  return {.name = name,
          .topic = Topic::bubble,
          .measure = measure,
          .standing = recommended,
          .formula = formula,
          .source = source,
          .note = bubble_note,
          .validity = deep,
          .evaluate = evaluate};
}

double theta(Situation const& s) {
  return s.size() * swisdak_water_time_constant(s.scaled_distance());
}

Outcome exponential(Situation const& s) {
  double const peak = s.explosive_factor * swisdak_water_pressure(s.scaled_distance());
  Outcome outcome = exponential_pulse(peak, theta(s), s.time);
  double const at = swisdak_range.of(s);
  return at >= swisdak_range.low && at <= swisdak_range.high
             ? outcome
             : std::move(outcome).outside("peak and time constant are outside their range");
}

/// A law for TNT in water below air at sea level; `outside` for other water.
Outcome below_sea_level_air(Situation const& s, double value) {
  bool const usual = s.water.surface_pressure == standard_pressure &&
                     s.water.density >= least_density && s.water.density <= most_density;
  if (usual) return value;
  return Outcome(value).outside(
      "measured in water of 1000 to 1030 kg/m^3 below air of 101.325 kPa, which it takes as 10 m "
      "of "
      "water");
}

double water_pressure(Situation const& s) { return s.water.pressure(s.depth); }

/// The energy given, or else that of the bubble of the radius law.
double energy(Situation const& s) {
  if (!std::isnan(s.bubble_energy)) return s.bubble_energy;
  return bubble_energy(bubble_radius(s.charge_mass, s.depth), water_pressure(s));
}

constexpr std::array list{
    water("cole", Measure::peak_pressure, recommended, "p = 52.4 X^1.13 MPa",
          "R. H. Cole, Underwater Explosions (1948), ch. 7",
          range_of("R/R_0", "charge radii", radii, 10.0, unbounded),
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * cole_pressure(s.scaled_distance());
          }),
    water("swisdak", Measure::peak_pressure, recommended, "p = 52.16 X^1.13 MPa",
          swisdak_water_source, swisdak_range,
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * swisdak_water_pressure(s.scaled_distance());
          }),
    water("zamyshlyaev", Measure::peak_pressure, comparison,
          "p = 44.1 X^1.5 MPa to 12 charge radii, 52.4 X^1.13 beyond", zamyshlyaev_source,
          zamyshlyaev_range,
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * zamyshlyaev_pressure(s.scaled_distance());
          }),
    water("kirkwood_brinkley", Measure::peak_pressure, comparison,
          "p = 22150 X [log10(1/X) + .873]^(-1/2) psi", cole_source,
          scaled_imperial(13.0, unbounded),
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * kirkwood_brinkley_pressure(s.scaled_distance());
          }),
    water("penney", Measure::peak_pressure, comparison, "p = 14100 X e^(.27 X) psi", cole_source,
          unstated,
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * penney_pressure(s.scaled_distance());
          }),
    water("swisdak", Measure::impulse, recommended, "I = 5.75 W^(1/3) X^.89 kPa s",
          swisdak_water_source, swisdak_range,
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * s.size() * swisdak_water_impulse(s.scaled_distance());
          }),
    water("inverse_distance", Measure::impulse, comparison, "I = 2.11 W^(2/3)/R lbf s/in^2",
          thesis_source, unstated,
          [](Situation const& s) -> Outcome {
            return s.explosive_factor * s.size() *
                   inverse_distance_water_impulse(s.scaled_distance());
          }),
    water("swisdak", Measure::time_constant, recommended, "theta = 96.5 W^(1/3) X^-.22 us",
          swisdak_water_source, swisdak_range,
          [](Situation const& s) -> Outcome { return theta(s); }),
    water("zamyshlyaev", Measure::time_constant, comparison,
          "theta = .45e-3 R_0 r^.45 to 30 radii, 3.5 (R_0/c) sqrt(log10 r - .9) beyond, 15 % lower",
          zamyshlyaev_source, zamyshlyaev_range,
          [](Situation const& s) -> Outcome {
            return s.size() * zamyshlyaev_time_constant(s.scaled_distance());
          }),
    water("swisdak", Measure::energy_per_area, recommended, "E = 84.4 W^(1/3) X^2.04 kJ/m^2",
          swisdak_water_source, swisdak_range,
          [](Situation const& s) -> Outcome {
            return s.size() * swisdak_water_energy(s.scaled_distance());
          }),
    water("shock_heating", Measure::energy_lost, comparison,
          "30 % of the shock's energy by 5 charge radii, 48 % by 25", thesis_source,
          range_of("R/R_0", "charge radii", radii, 5.0, 25.0),
          [](Situation const& s) -> Outcome { return energy_lost(s.scaled_distance()); }),
    Relation{.name = "exponential",
             .topic = Topic::water,
             .measure = Measure::overpressure,
             .standing = recommended,
             .formula = "p e^(-t/theta), with peak and time constant of swisdak",
             .source = cole_source,
             .validity = range_of(
                 "t/theta", "", [](Situation const& s) { return s.time / theta(s); }, 0.0, 1.0),
             .needs = "a time",
             .applies = [](Situation const& s) { return !std::isnan(s.time); },
             .evaluate = exponential},
    bubble("swisdak", Measure::bubble_radius, "a_m = 3.50 [W/(d+10)]^(1/3) m", swisdak_water_source,
           [](Situation const& s) {
             return below_sea_level_air(s, bubble_radius(s.charge_mass, s.depth));
           }),
    bubble("swisdak", Measure::bubble_period, "T = 2.11 W^(1/3)/(d+10)^(5/6) s",
           swisdak_water_source,
           [](Situation const& s) {
             return below_sea_level_air(s, bubble_period(s.charge_mass, s.depth));
           }),
    bubble("rayleigh", Measure::bubble_period, "T = 1.83 a_m sqrt(rho_0/P_0)",
           "Lord Rayleigh, Phil. Mag. 34 (1917) 94, with the radius above",
           [](Situation const& s) {
             return below_sea_level_air(s, rayleigh_period(bubble_radius(s.charge_mass, s.depth),
                                                           s.water.density, water_pressure(s)));
           }),
    bubble("willis", Measure::bubble_period, "T = 1.14 rho_0^(1/2) Y^(1/3)/P_0^(5/6)",
           "H. F. Willis (1941), in R. H. Cole, Underwater Explosions (1948), ch. 8",
           [](Situation const& s) -> Outcome {
             double const period = willis_period(energy(s), s.water.density, water_pressure(s));
             return std::isnan(s.bubble_energy) ? below_sea_level_air(s, period) : period;
           }),
    bubble("sphere", Measure::bubble_energy, "Y = (4 pi/3) P_0 a_m^3",
           "R. H. Cole, Underwater Explosions (1948), ch. 8, with the radius above",
           [](Situation const& s) {
             return below_sea_level_air(
                 s, bubble_energy(bubble_radius(s.charge_mass, s.depth), water_pressure(s)));
           }),
};

}  // namespace

std::span<Relation const> water_relations() { return list; }

}  // namespace moraine::blast
