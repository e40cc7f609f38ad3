// Gauges of kind expression, and of kind plane, which has files instead of readings.
#include "output/gauges/gauge_columns.hpp"
#include "output/gauges/makers.hpp"
#include "probes/expression_probe.hpp"

namespace moraine {

GaugeReader expression_reader(Case const& c, GaugeSpec const& gauge) {
  ExpressionSpec const& spec = gauge.probe.expression;
  auto const read = [selection = selection_of(c, gauge), formula = ParticleFormula(spec.formula),
                     reduce = spec.reduce,
                     weight = spec.weight](ReadingContext const& at, std::vector<double>& row) {
    ReducedValue const reduced =
        reduce_formula(at.simulation.particles(), selection, formula, reduce, weight,
                       at.simulation.model().numerics.smoothing_length(), at.simulation.time());
    row.push_back(reduced.value);
    return reduced.particles > 0;
  };
  constexpr std::array names{"max", "min", "mean", "sum", "integral"};
  std::string const name = gauge.name + ' ' + names[static_cast<std::size_t>(spec.reduce)];
  return {gauge.name, {{name, spec.unit}}, read};
}

GaugeReader plane_reader(Case const&, GaugeSpec const& gauge) {
  return {gauge.name, {}, [](ReadingContext const&, std::vector<double>&) { return true; }};
}

}  // namespace moraine
