#include "probes/expression_probe.hpp"

#include <cmath>
#include <limits>

namespace moraine {
namespace {

double weight_of(ParticleStore const& store, std::size_t i, Reduction reduction,
                 MeanWeight weight) {
  double const mass = store.scalar(Field::mass)[i];
  double const volume = mass / store.scalar(Field::density)[i];
  if (reduction == Reduction::integral) return volume;
  if (reduction == Reduction::sum || weight == MeanWeight::number) return 1.0;
  return weight == MeanWeight::mass ? mass : volume;
}

}  // namespace

ReducedValue reduce_formula(ParticleStore const& store, Selection const& selection,
                            ParticleFormula const& formula, Reduction reduction, MeanWeight weight,
                            double h, double time) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  ReducedValue result;
  double extreme = nothing, sum = 0.0, weights = 0.0;
  bool good = true;
  double const sign = reduction == Reduction::min ? -1.0 : 1.0;
  std::size_t const count = store.range(Kind::fluid).size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!selection.has(store, i)) continue;
    double const value = formula(store, i, h, time);
    good = good && !std::isnan(value);
    if (result.particles++ == 0 || sign * value > sign * extreme) extreme = value;
    double const w = weight_of(store, i, reduction, weight);
    sum += w * value;
    weights += w;
  }
  bool const sums = reduction == Reduction::sum || reduction == Reduction::integral;
  if (!good || (result.particles == 0 && !sums))
    result.value = nothing;
  else if (reduction == Reduction::mean)
    result.value = sum / weights;
  else
    result.value = sums ? sum : extreme;
  return result;
}

}  // namespace moraine
