#include "blast/relation.hpp"

#include <fmt/core.h>

#include <cmath>

namespace moraine::blast {
namespace {

std::vector<Relation> gather() {
  std::vector<Relation> all;
  for (auto const list :
       {kingery_air_relations(), air_relations(), kingery_surface_relations(), surface_relations(),
        reflection_relations(), pulse_relations(), line_relations(), ground_relations(),
        crater_relations(), water_relations()})
    all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

double Situation::scaled_distance() const { return distance / size(); }

double Situation::size() const { return std::cbrt(charge_mass); }

std::string_view name_of(Standing standing) {
  switch (standing) {
    case Standing::recommended:
      return "recommended";
    case Standing::comparison:
      return "comparison";
    case Standing::doubtful:
      break;
  }
  return "doubtful";
}

std::string_view name_of(Topic topic) {
  constexpr std::string_view names[] = {"air",    "surface", "reflection", "pulse",
                                        "line",   "contact", "buried",     "displacement",
                                        "crater", "water",   "bubble"};
  return names[static_cast<std::size_t>(topic)];
}

Outcome Outcome::none(std::string why) {
  Outcome outcome(unknown);
  outcome.caution = std::move(why);
  return outcome;
}

Outcome Outcome::outside(std::string warning) && {
  caution = std::move(warning);
  misused = true;
  return std::move(*this);
}

Outcome Outcome::in_doubt(std::string warning) && {
  caution = std::move(warning);
  doubtful = true;
  return std::move(*this);
}

std::span<Relation const> relations() {
  static std::vector<Relation> const all = gather();
  return all;
}

std::string describe(Validity const& validity) {
  if (validity.known == Validity::Known::everywhere) return "everywhere";
  if (validity.known == Validity::Known::unstated) return "no range stated by the source";
  std::string const unit =
      validity.unit.empty() ? std::string() : fmt::format(" {}", validity.unit);
  if (std::isinf(validity.high))
    return fmt::format("{} from {:.4g}{}", validity.variable, validity.low, unit);
  if (validity.low == 0.0)
    return fmt::format("{} up to {:.4g}{}", validity.variable, validity.high, unit);
  return fmt::format("{} of {:.4g} to {:.4g}{}", validity.variable, validity.low, validity.high,
                     unit);
}

}  // namespace moraine::blast
