// Line charges, charges in contact, buried charges, displacement and craters.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "blast/line_charge.hpp"
#include "blast/sources.hpp"
#include "blast/surface_burst.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Standing recommended = Standing::recommended, comparison = Standing::comparison,
                   doubtful = Standing::doubtful;

// Line charges.

double line_distance(Situation const& s) {
  return line_scaled_distance(s.charge_mass, s.length, s.distance);
}

/// Where the swept air outweighs the charge ten times, up to the end of the table, in m/sqrt(kg/m).
constexpr Validity line_range = range_of("R sqrt(L/W)", "m/sqrt(kg/m)", line_distance, 1.6, 5100.0);

Outcome line_source(Situation const& s) {
  double const energy = tnt_energy * s.charge_mass;
  double const r0 = sachs_length(Source::line, energy, s.length, s.air.pressure);
  Outcome outcome = s.explosive_factor * s.air.pressure * line_source_overpressure(s.distance / r0);
  bool const long_enough = s.distance <= 0.5 * s.length;
  return long_enough ? outcome
                     : std::move(outcome).outside(
                           "farther away than half the length of the charge: its ends are felt");
}

template <Source source>
Outcome sachs(Situation const& s) {
  return sachs_length(source, tnt_energy * s.charge_mass, s.length, s.air.pressure);
}

constexpr Relation sachs_relation(Measure measure, std::string_view formula,
                                  Outcome (*evaluate)(Situation const&)) {
  return {.name = "sachs",
          .topic = Topic::line,
          .measure = measure,
          .standing = recommended,
          .formula = formula,
          .source = "R. G. Sachs, BRL 466 (1944); with E = 4.61 MJ/kg",
          .validity = everywhere,
          .evaluate = evaluate};
}

// Buried charges.

BuriedCharge buried(Situation const& s) {
  return {s.charge_mass, s.distance, s.soil->k, s.explosive_factor, s.coupling};
}

/// Marks what an uncertain soil gives.
Outcome in_soil(Situation const& s, double value) {
  Outcome outcome = value;
  if (!s.soil->doubtful) return outcome;
  return std::move(outcome).in_doubt(fmt::format("{}: {}", s.soil->name, s.soil->note));
}

constexpr Relation buried_relation(Measure measure, std::string_view formula, std::string_view note,
                                   Outcome (*evaluate)(Situation const&)) {
  return {.name = "lampson",
          .topic = Topic::buried,
          .measure = measure,
          .standing = recommended,
          .formula = formula,
          .source = lampson_source,
          .note = note,
          .validity = scaled_imperial(2.0, 15.0),
          .evaluate = evaluate};
}

// Displacement.

constexpr Relation displacement_relation(std::string_view name, Measure measure,
                                         std::string_view formula,
                                         Outcome (*evaluate)(Situation const&),
                                         bool (*applies)(Situation const&),
                                         std::string_view needs) {
  return {.name = name,
          .topic = Topic::displacement,
          .measure = measure,
          .standing = recommended,
          .formula = formula,
          .source = lampson_source,
          .note = "none was measured beyond 10; the lower end is that of the pressures",
          .validity = scaled_imperial(least_displacement_distance, most_displacement_distance),
          .needs = needs,
          .applies = applies,
          .evaluate = evaluate};
}

bool ground_known(Situation const& s) { return s.displaced != nullptr; }
bool in_sand(Situation const& s) { return s.displaced != nullptr && s.displaced->name == "sand"; }

// Craters.

/// A law for charges on the ground; `scatter` of its source.
Outcome surface_crater(Situation const& s, double c, double scatter) {
  double const d = crater_diameter(s.charge_mass, c);
  Outcome outcome(d, d * (1.0 - scatter), d * (1.0 + scatter));
  bool const below = s.depth > charge_radius(s.charge_mass);
  return below ? std::move(outcome).outside("for charges on the ground, not below it") : outcome;
}

constexpr std::array list{
    Relation{.name = "line_source",
             .topic = Topic::line,
             .measure = Measure::peak_overpressure,
             .standing = recommended,
             .formula = "p/p_a = f(R/R_0), R_0 = sqrt(E/(L p_a)), E = 4.61 MJ/kg",
             .source = "S. Hancock, Blast::IPS, ideal line source with gamma = 1.4",
             .note = "from where the swept air outweighs the charge ten times",
             .validity = line_range,
             .evaluate = line_source},
    sachs_relation(Measure::sachs_length_of_plane, "R_0 = E/(p_a L^2)", sachs<Source::plane>),
    sachs_relation(Measure::sachs_length_of_line, "R_0 = sqrt(E/(p_a L))", sachs<Source::line>),
    sachs_relation(Measure::sachs_length_of_point, "R_0 = (E/p_a)^(1/3)", sachs<Source::point>),
    Relation{.name = "thesis_contact",
             .topic = Topic::contact,
             .measure = Measure::contact_impulse,
             .standing = comparison,
             .formula = "I = W [183 - 191/(1.1 + sqrt(a b/d^2))] lbf s, W in lb",
             .source = thesis_source,
             .validity = unstated,
             .evaluate = [](Situation const& s) -> Outcome {
               return s.explosive_factor *
                      contact_impulse(s.charge_mass, s.side_a, s.side_b, s.height);
             }},
    buried_relation(Measure::peak_pressure, "p = E f k Z^-3 psi", "",
                    [](Situation const& s) { return in_soil(s, buried_pressure(buried(s))); }),
    buried_relation(Measure::impulse, "I = .076 E k^(1/2) f W^(1/3) Z^(-5/2) psi s", "",
                    [](Situation const& s) { return in_soil(s, buried_impulse(buried(s))); }),
    buried_relation(Measure::target_impulse, "three times the impulse, on a fixed target", "",
                    [](Situation const& s) {
                      return in_soil(s, fixed_target_factor * buried_impulse(buried(s)));
                    }),
    buried_relation(
        Measure::positive_duration, "t+ = .174 k^(-1/2) R^(1/2) W^(1/6) s",
        "powers corrected to those of 2 I/p",
        [](Situation const& s) { return in_soil(s, buried_positive_duration(buried(s))); }),
    buried_relation(
        Measure::negative_duration, "t- = .368 k^(-1/2) R^(1/2) W^(1/6) s",
        "powers corrected to those of 2 I/p",
        [](Situation const& s) { return in_soil(s, buried_negative_duration(buried(s))); }),
    displacement_relation(
        "lampson", Measure::horizontal_displacement, "U/W^(1/3) = C Z^-4 in/lb^(1/3)",
        [](Situation const& s) -> Outcome {
          return permanent_displacement(s.charge_mass, s.distance, s.displaced->horizontal);
        },
        ground_known, "a ground"),
    displacement_relation(
        "lampson", Measure::vertical_displacement, "V/W^(1/3) = C Z^-4 in/lb^(1/3)",
        [](Situation const& s) -> Outcome {
          return permanent_displacement(s.charge_mass, s.distance, s.displaced->vertical);
        },
        ground_known, "a ground"),
    displacement_relation(
        "medium_sand", Measure::transient_horizontal_displacement,
        "47.3 Z^-3 + .216 Z^-1 in/lb^(1/3)",
        [](Situation const& s) -> Outcome {
          return transient_horizontal_displacement(s.charge_mass, s.distance);
        },
        in_sand, "sand as the ground"),
    displacement_relation(
        "medium_sand", Measure::transient_vertical_displacement,
        "12.6 Z^-3 + .032 Z^-1 in/lb^(1/3)",
        [](Situation const& s) -> Outcome {
          return transient_vertical_displacement(s.charge_mass, s.distance);
        },
        in_sand, "sand as the ground"),
    Relation{.name = "kinney_graham",
             .topic = Topic::crater,
             .measure = Measure::crater_diameter,
             .standing = recommended,
             .formula = "D = .8 W^(1/3) m, within 30 %",
             .source = kinney_source,
             .validity = unstated,
             .evaluate =
                 [](Situation const& s) { return surface_crater(s, kinney_graham_crater, 0.3); }},
    Relation{
        .name = "ambrosini",
        .topic = Topic::crater,
        .measure = Measure::crater_diameter,
        .standing = recommended,
        .formula = "D = .51 W^(1/3) m, within 5 %, a sphere that rests on soil",
        .source = "D. Ambrosini et al., Shock Waves 12 (2002) 69",
        .validity = unstated,
        .evaluate = [](Situation const& s) { return surface_crater(s, ambrosini_crater, 0.05); }},
    Relation{.name = "hemispherical",
             .topic = Topic::crater,
             .measure = Measure::crater_diameter,
             .standing = comparison,
             .formula = "D = .65 W^(1/3) m, about, a hemisphere at ground level",
             .source = "in use; its source is not verified",
             .validity = unstated,
             .evaluate =
                 [](Situation const& s) { return surface_crater(s, hemispherical_crater, 0.0); }},
    Relation{
        .name = "lampson",
        .topic = Topic::crater,
        .measure = Measure::crater_diameter,
        .standing = doubtful,
        .formula = "D = 2.6 f k^.05 W^(1/3) ft",
        .source = lampson_source,
        .note = "the power of k is printed as .5, by which 1 lb would leave 184 ft",
        .validity = unstated,
        .needs = "a soil and a depth factor",
        .applies =
            [](Situation const& s) { return s.soil != nullptr && !std::isnan(s.depth_factor); },
        .evaluate = [](Situation const& s) -> Outcome {
          return lampson_crater_diameter(s.charge_mass, s.soil->k, s.depth_factor);
        }},
    Relation{.name = "rupture",
             .topic = Topic::crater,
             .measure = Measure::rupture_radius,
             .standing = comparison,
             .formula = "R = F W^(1/3) ft, F by ground",
             .source = thesis_source,
             .validity = unstated,
             .needs = "a ground",
             .applies = [](Situation const& s) { return s.broken != nullptr; },
             .evaluate = [](Situation const& s) -> Outcome {
               double const low = rupture_radius(s.charge_mass, s.broken->low);
               double const high = rupture_radius(s.charge_mass, s.broken->high);
               return {0.5 * (low + high), low, high};
             }},
    Relation{
        .name = "camouflet",
        .topic = Topic::crater,
        .measure = Measure::camouflet_volume,
        .standing = comparison,
        .formula = "V = 10 W ft^3, W in lb, in clay",
        .source = thesis_source,
        .note = "of a charge so deep that it does not break through",
        .validity = unstated,
        .needs = "clay as the ground",
        .applies =
            [](Situation const& s) { return s.broken != nullptr && s.broken->name == "clay"; },
        .evaluate = [](Situation const& s) -> Outcome { return camouflet_volume(s.charge_mass); }},
};

}  // namespace

std::span<Relation const> ground_relations() { return list; }

}  // namespace moraine::blast
