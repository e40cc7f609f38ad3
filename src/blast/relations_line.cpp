// Line charges.
#include <array>

#include "blast/line_charge.hpp"
#include "blast/sources.hpp"
#include "blast/validity.hpp"

namespace moraine::blast {
namespace {

double energy(Situation const& s) { return tnt_energy * s.charge_mass; }

double sachs_ratio(Situation const& s) {
  return s.distance / sachs_length(Source::line, energy(s), s.length, s.air.pressure);
}

/// From where the swept air outweighs the charge ten times (at 15 degrees Celsius, whatever the
/// pressure) to the end of the table.
constexpr Validity line_range = range_of("R/R_0", "", sachs_ratio, 0.239, most_line_ratio);

Outcome line_source(Situation const& s) {
  Outcome outcome = s.explosive_factor * s.air.pressure * line_source_overpressure(sachs_ratio(s));
  bool const long_enough = s.distance <= 0.5 * s.length;
  return long_enough ? outcome
                     : std::move(outcome).outside(
                           "farther away than half the length of the charge: its ends are felt");
}

template <Source source>
Outcome sachs(Situation const& s) {
  return sachs_length(source, energy(s), s.length, s.air.pressure);
}

constexpr Relation sachs_relation(Measure measure, std::string_view formula,
                                  Outcome (*evaluate)(Situation const&)) {
  return {.name = "sachs",
          .topic = Topic::line,
          .measure = measure,
          .standing = Standing::recommended,
          .formula = formula,
          .source = "R. G. Sachs, BRL 466 (1944); with E = 4.61 MJ/kg",
          .validity = everywhere,
          .evaluate = evaluate};
}

constexpr std::array list{
    Relation{
        .name = "line_source",
        .topic = Topic::line,
        .measure = Measure::peak_overpressure,
        .standing = Standing::recommended,
        .formula = "p/p_a = f(R/R_0), R_0 = sqrt(E/(L p_a)), E = 4.61 MJ/kg",
        .source = "S. Hancock, Blast::IPS, ideal line source with gamma = 1.4",
        .note = "from where the swept air outweighs the charge ten times, the program's choice",
        .validity = line_range,
        .evaluate = line_source},
    sachs_relation(Measure::sachs_length_of_plane, "R_0 = E/(p_a L^2)", sachs<Source::plane>),
    sachs_relation(Measure::sachs_length_of_line, "R_0 = sqrt(E/(p_a L))", sachs<Source::line>),
    sachs_relation(Measure::sachs_length_of_point, "R_0 = (E/p_a)^(1/3)", sachs<Source::point>),
};

}  // namespace

std::span<Relation const> line_relations() { return list; }

}  // namespace moraine::blast
