#include "output/blast/answer_json.hpp"

#include <algorithm>
#include <cmath>

namespace moraine::blast {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no NaN and no infinity.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json range_json(Validity const& validity) {
  Json json{{"text", describe(validity)}};
  if (validity.known != Validity::Known::range) return json;
  json["variable"] = validity.variable;
  json["unit"] = validity.unit;
  json["low"] = number(validity.low);
  json["high"] = number(validity.high);
  return json;
}

Json estimate_json(Estimate const& estimate, OutputUnits const& units) {
  Relation const& relation = *estimate.relation;
  Measure const measure = relation.measure;
  Json range = range_json(relation.validity);
  range["at"] = number(estimate.variable);
  return Json{{"measure", info(measure).name},
              {"relation", relation.name},
              {"value", number(units.shown(measure, estimate.value))},
              {"low", number(units.shown(measure, estimate.low))},
              {"high", number(units.shown(measure, estimate.high))},
              {"unit", units.unit(measure)},
              {"standing", name_of(estimate.standing)},
              {"in_range", estimate.in_range},
              {"range", std::move(range)},
              {"warnings", estimate.warnings},
              {"formula", relation.formula},
              {"source", relation.source},
              {"note", relation.note}};
}

}  // namespace

Json to_json(Answer const& answer, OutputUnits const& units) {
  Json json{
      {"estimates", Json::array()}, {"spreads", Json::array()}, {"unanswered", Json::array()}};
  for (Estimate const& estimate : answer.estimates)
    json["estimates"].push_back(estimate_json(estimate, units));
  for (Spread const& spread : answer.spreads)
    json["spreads"].push_back({{"measure", info(spread.measure).name},
                               {"relations", spread.count},
                               {"low", number(units.shown(spread.measure, spread.low))},
                               {"high", number(units.shown(spread.measure, spread.high))},
                               {"unit", units.unit(spread.measure)},
                               {"factor", number(spread.high / spread.low)}});
  for (Unanswered const& unanswered : answer.unanswered)
    json["unanswered"].push_back({{"measure", info(unanswered.relation->measure).name},
                                  {"relation", unanswered.relation->name},
                                  {"needs", unanswered.needs}});
  return json;
}

Json to_json(GaugeReadings const& gauge, Answer const& answer, OutputUnits const& units) {
  Json json{{"name", gauge.gauge}, {"readings", Json::array()}};
  for (auto const& [measure, value] : gauge.readings) {
    auto const same = [wanted = measure](Estimate const& e) {
      return e.relation->measure == wanted;
    };
    if (std::ranges::none_of(answer.estimates, same)) continue;
    Json reading{{"measure", info(measure).name},
                 {"value", number(units.shown(measure, value))},
                 {"unit", units.unit(measure)}};
    if (Estimate const* beside = yardstick(answer, measure)) {
      reading["relation"] = beside->relation->name;
      reading["ratio"] = number(value / beside->value);
    }
    json["readings"].push_back(std::move(reading));
  }
  return json;
}

Json to_json(std::span<Relation const> relations) {
  Json json = Json::array();
  for (Relation const& relation : relations)
    json.push_back({{"topic", name_of(relation.topic)},
                    {"measure", info(relation.measure).name},
                    {"relation", relation.name},
                    {"standing", name_of(relation.standing)},
                    {"formula", relation.formula},
                    {"source", relation.source},
                    {"range", range_json(relation.validity)},
                    {"note", relation.note}});
  return json;
}

}  // namespace moraine::blast
