// Charges on the ground.
#include <array>
#include <cmath>

#include "blast/free_air.hpp"
#include "blast/kingery_relations.hpp"
#include "blast/kingery_swisdak.hpp"
#include "blast/sources.hpp"
#include "blast/surface_burst.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Topic topic = Topic::surface;

constexpr Relation swisdak_relation(Measure measure, ScaledRange const& range,
                                    Outcome (*evaluate)(Situation const&)) {
  return {.name = "kingery_swisdak",
          .topic = topic,
          .measure = measure,
          .standing = Standing::recommended,
          .formula = "Y = exp(sum c_i (ln Z)^i)",
          .source = "M. M. Swisdak, Simplified Kingery airblast calculations (1994)",
          .note = "another fit to the data of Kingery-Bulmash",
          .validity = scaled_metric(range.low, range.high),
          .sea_level_air = true,
          .evaluate = evaluate};
}

/// A relation for free air with the charge enlarged by the ground: the value and what the ends of
/// the range of that factor give.
template <class Law>
Outcome enlarged(Situation const& s, Law const& law) {
  auto const at = [&](double factor) {
    return s.explosive_factor * law(s.scaled_distance() / std::cbrt(factor));
  };
  Outcome outcome(at(s.ground_factor), at(least_ground_factor), at(most_ground_factor));
  bool const usual =
      s.ground_factor >= least_ground_factor && s.ground_factor <= most_ground_factor;
  return usual ? outcome : std::move(outcome).outside("ground factors are 1.7 to 2");
}

constexpr Validity enlarged_range(double low, double high) {
  return range_of(
      "R/(f W)^(1/3)", "m/kg^(1/3)",
      [](Situation const& s) { return s.scaled_distance() / std::cbrt(s.ground_factor); }, low,
      high);
}

constexpr std::array list{
    swisdak_relation(Measure::peak_overpressure, swisdak_overpressure_range,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor * swisdak_overpressure(s.scaled_distance());
                     }),
    Relation{.name = "kinney_graham_enlarged",
             .topic = topic,
             .measure = Measure::peak_overpressure,
             .standing = Standing::comparison,
             .formula = "kinney_graham of free air with f W, f of 1.7 to 2",
             .source = kinney_source,
             .validity = enlarged_range(0.0532, 39.6),
             .sea_level_air = true,
             .evaluate =
                 [](Situation const& s) {
                   return enlarged(
                       s, [&](double z) { return kinney_graham_overpressure(z, s.air.pressure); });
                 }},
    Relation{.name = "henrych_enlarged",
             .topic = topic,
             .measure = Measure::peak_overpressure,
             .standing = Standing::comparison,
             .formula = "henrych of free air with f W, f of 1.7 to 2",
             .source = "J. Henrych, The Dynamics of Explosion and its Use (1979), ch. 4",
             .validity = enlarged_range(0.05, 10.0),
             .sea_level_air = true,
             .evaluate = [](Situation const& s) { return enlarged(s, henrych_overpressure); }},
    swisdak_relation(Measure::reflected_overpressure, swisdak_range,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor *
                              swisdak_reflected_overpressure(s.scaled_distance());
                     }),
    swisdak_relation(Measure::impulse, swisdak_impulse_range,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor * s.size() * swisdak_impulse(s.scaled_distance());
                     }),
    Relation{.name = "inverse_distance",
             .topic = topic,
             .measure = Measure::impulse,
             .standing = Standing::comparison,
             .formula = "I = K W^(2/3)/R lbf s/in^2, K .054, heavy case .036, bare .081",
             .source = thesis_source,
             .note = "between the bounds the case decides",
             .validity = unstated,
             .sea_level_air = true,
             .evaluate = [](Situation const& s) -> Outcome {
               auto const at = [&](double k) {
                 return s.explosive_factor * surface_impulse(s.charge_mass, s.distance, k);
               };
               return {at(usual_impulse_factor), at(heavy_case_impulse_factor),
                       at(bare_charge_impulse_factor)};
             }},
    swisdak_relation(Measure::reflected_impulse, swisdak_range,
                     [](Situation const& s) -> Outcome {
                       return s.explosive_factor * s.size() *
                              swisdak_reflected_impulse(s.scaled_distance());
                     }),
    swisdak_relation(Measure::arrival_time, swisdak_range,
                     [](Situation const& s) -> Outcome {
                       return s.size() * swisdak_arrival_time(s.scaled_distance());
                     }),
    swisdak_relation(Measure::positive_duration, swisdak_duration_range,
                     [](Situation const& s) -> Outcome {
                       return s.size() * swisdak_duration(s.scaled_distance());
                     }),
    swisdak_relation(
        Measure::front_speed, swisdak_range,
        [](Situation const& s) -> Outcome { return swisdak_front_speed(s.scaled_distance()); }),
};

}  // namespace

std::span<Relation const> surface_relations() { return list; }

std::span<Relation const> kingery_surface_relations() {
  static constexpr auto kingery = kingery_relations<Burst::surface>(topic);
  return kingery;
}

}  // namespace moraine::blast
