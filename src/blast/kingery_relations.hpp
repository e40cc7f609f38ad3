// What Kingery and Bulmash say of a burst, and what their front does in an ideal gas.
#pragma once

#include <fmt/core.h>

#include <array>

#include "blast/kingery_bulmash.hpp"
#include "blast/relation.hpp"
#include "blast/sources.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {

template <Burst burst>
double kingery_peak(Situation const& s) {
  return s.explosive_factor * kingery_overpressure(burst, s.scaled_distance());
}

/// What a law for fronts in an ideal gas makes of the peak.
template <Burst burst, class Law>
Outcome behind_kingery_front(Situation const& s, Law const& law) {
  constexpr double most = 40.0;
  double const strength = kingery_peak<burst>(s) / s.air.pressure;
  Outcome outcome = law(kingery_peak<burst>(s));
  if (strength <= most) return outcome;
  return std::move(outcome).outside(
      fmt::format("p/p_a is {:.3g}: above {:.0f} air is no ideal gas", strength, most));
}

template <Burst burst>
constexpr Relation kingery_relation(Topic topic, Measure measure,
                                    Outcome (*evaluate)(Situation const&)) {
  bool const duration = measure == Measure::positive_duration;
  return {
      .name = "kingery_bulmash",
      .topic = topic,
      .measure = measure,
      .standing = Standing::recommended,
      .formula = "log10 Y = sum c_i (U_0 + U_1 log10 Z)^i",
      .source = kingery_source,
      .note = burst == Burst::surface ? "hemispherical charge on rigid ground" : "",
      .validity = scaled_imperial(duration ? kingery_duration_range(burst) : kingery_range(burst)),
      .sea_level_air = true,
      .evaluate = evaluate};
}

template <Burst burst>
constexpr Relation front_relation(Topic topic, Measure measure, std::string_view formula,
                                  Outcome (*evaluate)(Situation const&)) {
  return {.name = "rankine_hugoniot",
          .topic = topic,
          .measure = measure,
          .standing = Standing::recommended,
          .formula = formula,
          .source = rankine_source,
          .note = "with the peak of Kingery-Bulmash",
          .validity = scaled_imperial(kingery_range(burst)),
          .sea_level_air = true,
          .evaluate = evaluate};
}

/// The ten relations of a burst, for the list of its topic.
template <Burst burst>
constexpr std::array<Relation, 10> kingery_relations(Topic topic) {
  using S = Situation const&;
  auto const kingery = [&](Measure measure, Outcome (*evaluate)(S)) {
    return kingery_relation<burst>(topic, measure, evaluate);
  };
  auto const front = [&](Measure measure, std::string_view formula, Outcome (*evaluate)(S)) {
    return front_relation<burst>(topic, measure, formula, evaluate);
  };
  return {
      kingery(Measure::peak_overpressure, [](S s) -> Outcome { return kingery_peak<burst>(s); }),
      kingery(Measure::reflected_overpressure,
              [](S s) -> Outcome {
                return s.explosive_factor *
                       kingery_reflected_overpressure(burst, s.scaled_distance());
              }),
      kingery(Measure::impulse,
              [](S s) -> Outcome {
                return s.explosive_factor * s.size() * kingery_impulse(burst, s.scaled_distance());
              }),
      kingery(Measure::reflected_impulse,
              [](S s) -> Outcome {
                return s.explosive_factor * s.size() *
                       kingery_reflected_impulse(burst, s.scaled_distance());
              }),
      kingery(Measure::arrival_time,
              [](S s) -> Outcome {
                return s.size() * kingery_arrival_time(burst, s.scaled_distance());
              }),
      kingery(
          Measure::positive_duration,
          [](S s) -> Outcome { return s.size() * kingery_duration(burst, s.scaled_distance()); }),
      front(Measure::reflected_overpressure, "p_r = 2p (7p_a + 4p)/(7p_a + p)",
            [](S s) {
              return behind_kingery_front<burst>(
                  s, [&](double p) { return normal_reflection(p, s.air.pressure); });
            }),
      front(Measure::dynamic_pressure, "q = 2.5 p^2/(7p_a + p)",
            [](S s) {
              return behind_kingery_front<burst>(
                  s, [&](double p) { return dynamic_pressure(p, s.air); });
            }),
      front(Measure::front_speed, "U = c sqrt(1 + 6p/7p_a)",
            [](S s) {
              return behind_kingery_front<burst>(s,
                                                 [&](double p) { return front_speed(p, s.air); });
            }),
      front(Measure::particle_speed, "u = c (5p/7p_a)/sqrt(1 + 6p/7p_a)",
            [](S s) {
              return behind_kingery_front<burst>(
                  s, [&](double p) { return particle_speed(p, s.air); });
            }),
  };
}

}  // namespace moraine::blast
