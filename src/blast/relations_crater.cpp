// Craters, rupture radius and camouflet.
#include <array>
#include <cmath>

#include "blast/sources.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Standing recommended = Standing::recommended, comparison = Standing::comparison,
                   doubtful = Standing::doubtful;

constexpr Topic topic = Topic::crater;

/// A law for charges on the ground; `scatter` of its source.
Outcome surface_crater(Situation const& s, double c, double scatter) {
  double const d = crater_diameter(s.charge_mass, c);
  Outcome outcome(d, d * (1.0 - scatter), d * (1.0 + scatter));
  bool const below = s.depth > charge_radius(s.charge_mass);
  return below ? std::move(outcome).outside("for charges on the ground, not below it") : outcome;
}

constexpr std::array list{
    Relation{.name = "kinney_graham",
             .topic = topic,
             .measure = Measure::crater_diameter,
             .standing = recommended,
             .formula = "D = .8 W^(1/3) m, within 30 %",
             .source = kinney_source,
             .validity = unstated,
             .evaluate =
                 [](Situation const& s) { return surface_crater(s, kinney_graham_crater, 0.3); }},
    Relation{
        .name = "ambrosini",
        .topic = topic,
        .measure = Measure::crater_diameter,
        .standing = recommended,
        .formula = "D = .51 W^(1/3) m, within 5 %, a sphere that rests on soil",
        .source = "D. Ambrosini et al., Shock Waves 12 (2002) 69",
        .validity = unstated,
        .evaluate = [](Situation const& s) { return surface_crater(s, ambrosini_crater, 0.05); }},
    Relation{.name = "hemispherical",
             .topic = topic,
             .measure = Measure::crater_diameter,
             .standing = doubtful,
             .formula = "D = .65 W^(1/3) m, about, a hemisphere at ground level",
             .source = "quoted without one",
             .note = "in use, but where it comes from is not known",
             .validity = unstated,
             .evaluate =
                 [](Situation const& s) { return surface_crater(s, hemispherical_crater, 0.0); }},
    Relation{
        .name = "lampson",
        .topic = topic,
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
             .topic = topic,
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
        .topic = topic,
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

std::span<Relation const> crater_relations() { return list; }

}  // namespace moraine::blast
