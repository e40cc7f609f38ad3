// Shapes of pressure histories.
#include <array>
#include <cmath>

#include "blast/pulse.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

constexpr Topic topic = Topic::pulse;
constexpr std::string_view friedlander_source = "F. G. Friedlander, Proc. R. Soc. A 186 (1946) 322";

bool has_decay(Situation const& s) { return !std::isnan(s.decay); }
bool has_time(Situation const& s) { return !std::isnan(s.time); }
bool has_both(Situation const& s) { return has_decay(s) && has_time(s); }

constexpr std::array list{
    Relation{.name = "triangle",
             .topic = topic,
             .measure = Measure::impulse,
             .standing = Standing::recommended,
             .formula = "I = p t_0/2",
             .source = "definition",
             .validity = everywhere,
             .evaluate = [](Situation const& s) -> Outcome {
               return triangle_impulse(s.overpressure, s.duration);
             }},
    Relation{.name = "friedlander",
             .topic = topic,
             .measure = Measure::impulse,
             .standing = Standing::recommended,
             .formula = "I = p t_0 [1/k - (1 - e^-k)/k^2]",
             .source = friedlander_source,
             .validity = everywhere,
             .needs = "a decay or an impulse",
             .applies = has_decay,
             .evaluate = [](Situation const& s) -> Outcome {
               return friedlander_impulse(s.overpressure, s.duration, s.decay);
             }},
    Relation{.name = "triangle",
             .topic = topic,
             .measure = Measure::overpressure,
             .standing = Standing::recommended,
             .formula = "p (1 - t/t_0), none after t_0",
             .source = "definition",
             .validity = everywhere,
             .needs = "a time",
             .applies = has_time,
             .evaluate = [](Situation const& s) -> Outcome {
               return triangle_pulse(s.overpressure, s.duration, s.time);
             }},
    Relation{.name = "friedlander",
             .topic = topic,
             .measure = Measure::overpressure,
             .standing = Standing::recommended,
             .formula = "p (1 - t/t_0) e^(-k t/t_0)",
             .source = friedlander_source,
             .validity = everywhere,
             .needs = "a time and a decay or an impulse",
             .applies = has_both,
             .evaluate = [](Situation const& s) -> Outcome {
               return friedlander_pulse(s.overpressure, s.duration, s.decay, s.time);
             }},
    Relation{.name = "friedlander",
             .topic = topic,
             .measure = Measure::suction,
             .standing = Standing::recommended,
             .formula = "lowest overpressure, -p e^(-1-k)/k at t_0 (1 + 1/k)",
             .source = friedlander_source,
             .note = "fitted to the positive phase; the negative one follows it only roughly",
             .validity = everywhere,
             .needs = "a decay or an impulse",
             .applies = [](Situation const& s) { return s.decay > 0.0; },
             .evaluate = [](Situation const& s) -> Outcome {
               return friedlander_suction(s.overpressure, s.duration, s.decay);
             }},
};

}  // namespace

std::span<Relation const> pulse_relations() { return list; }

}  // namespace moraine::blast
