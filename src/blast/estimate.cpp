#include "blast/estimate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "blast/sachs.hpp"

namespace moraine::blast {
namespace {

/// Ends of a range are part of it, to rounding.
bool within(Validity const& validity, double variable) {
  return variable >= validity.low * (1.0 - 1e-12) && variable <= validity.high * (1.0 + 1e-12);
}

std::string outside(Validity const& validity, double variable) {
  std::string const unit =
      validity.unit.empty() ? std::string() : fmt::format(" {}", validity.unit);
  return fmt::format("outside its range: {} is {:.4g}{}, it holds for {}", validity.variable,
                     variable, unit, describe(validity));
}

Estimate evaluate(Relation const& relation, Situation const& situation) {
  bool const other_air = relation.sea_level_air && !situation.air_is_standard();
  Situation const used = other_air ? at_sea_level(situation) : situation;
  double const factor = other_air ? sachs_factor(info(relation.measure).kind, situation.air) : 1.0;
  Outcome outcome = relation.evaluate(used);
  Estimate estimate{&relation,
                    factor * outcome.value,
                    factor * outcome.low,
                    factor * outcome.high,
                    unknown,
                    true,
                    relation.standing,
                    {}};
  if (outcome.doubtful) estimate.standing = Standing::doubtful;
  if (relation.validity.known == Validity::Known::range) {
    estimate.variable = relation.validity.of(used);
    estimate.in_range = within(relation.validity, estimate.variable);
    if (!estimate.in_range)
      estimate.warnings.push_back(outside(relation.validity, estimate.variable));
  } else if (relation.validity.known == Validity::Known::unstated) {
    estimate.warnings.emplace_back("its source states no range");
  }
  if (!outcome.caution.empty()) estimate.warnings.push_back(std::move(outcome.caution));
  if (estimate.standing == Standing::doubtful)
    estimate.warnings.push_back(relation.note.empty() ? std::string("doubtful")
                                                      : fmt::format("doubtful: {}", relation.note));
  if (other_air) estimate.warnings.emplace_back(sachs_caution);
  if (outcome.misused || !std::isfinite(estimate.value)) estimate.in_range = false;
  return estimate;
}

std::vector<Spread> spreads_of(std::vector<Estimate> const& estimates) {
  std::vector<Spread> spreads;
  for (Estimate const& estimate : estimates) {
    if (!estimate.in_range || estimate.standing == Standing::doubtful) continue;
    Measure const measure = estimate.relation->measure;
    auto spread = std::ranges::find(spreads, measure, &Spread::measure);
    if (spread == spreads.end())
      spread = spreads.insert(spreads.end(), {measure, 0, estimate.value, estimate.value});
    ++spread->count;
    spread->low = std::min(spread->low, estimate.value);
    spread->high = std::max(spread->high, estimate.value);
  }
  std::erase_if(spreads, [](Spread const& spread) { return spread.count < 2; });
  return spreads;
}

}  // namespace

Answer answer(Topic topic, Situation const& situation) {
  Answer result;
  for (Relation const& relation : relations()) {
    if (relation.topic != topic) continue;
    if (relation.applies == nullptr || relation.applies(situation))
      result.estimates.push_back(evaluate(relation, situation));
    else if (!relation.needs.empty())
      result.unanswered.push_back({&relation, std::string(relation.needs)});
  }
  std::ranges::stable_sort(result.estimates, {},
                           [](Estimate const& estimate) { return estimate.relation->measure; });
  result.spreads = spreads_of(result.estimates);
  return result;
}

}  // namespace moraine::blast
