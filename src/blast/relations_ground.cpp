// Charges in contact, buried charges and displacement of the ground.
#include <fmt/core.h>

#include <array>

#include "blast/sources.hpp"
#include "blast/surface_burst.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

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
          .standing = Standing::recommended,
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
          .standing = Standing::recommended,
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

constexpr std::array list{
    Relation{.name = "slenderness",
             .topic = Topic::contact,
             .measure = Measure::contact_impulse,
             .standing = Standing::comparison,
             .formula = "I = W [183 - 191/(1.1 + sqrt(a b/d^2))] lbf s, W in lb",
             .source = thesis_source,
             .note = "an impulse in all, not per area as its unit is printed",
             .validity = unstated,
             .evaluate = [](Situation const& s) -> Outcome {
               return s.explosive_factor *
                      contact_impulse(s.charge_mass, s.side_a, s.side_b, s.height);
             }},
    buried_relation(Measure::peak_pressure, "p = E f k Z^-3 psi", "unit corrected to psi",
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
};

}  // namespace

std::span<Relation const> ground_relations() { return list; }

}  // namespace moraine::blast
