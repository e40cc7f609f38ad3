// The closed list of relations: each a formula with its source, its range and its standing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blast/measure.hpp"
#include "blast/situation.hpp"

namespace moraine::blast {

/// Recommended; given to compare with; or in doubt: shown, marked and left out of any spread.
enum class Standing : std::uint8_t { recommended, comparison, doubtful };
std::string_view name_of(Standing standing);

/// What a question is about; also the commands below `moraine blast`.
enum class Topic : std::uint8_t {
  air,
  surface,
  reflection,
  pulse,
  line,
  contact,
  buried,
  displacement,
  crater,
  water,
  bubble,
};
std::string_view name_of(Topic topic);

/// Where a relation holds: low <= variable <= high, in the relation's own variable and unit; or
/// everywhere, because it is a definition or an exact theory; or its source does not say.
struct Validity {
  enum class Known : std::uint8_t { range, everywhere, unstated };
  Known known = Known::unstated;
  std::string_view variable = "";
  std::string_view unit = "";
  double (*of)(Situation const&) = nullptr;
  double low = 0.0;
  double high = 0.0;  // may be infinite
};

/// What a relation gives, in SI. `low` and `high` bound its own scatter, where its source states
/// one.
struct Outcome {
  Outcome(double v) : Outcome(v, v, v) {}  // NOLINT: a plain number is an outcome
  Outcome(double v, double l, double h) : value(v), low(l), high(h) {}

  /// No value, and why.
  static Outcome none(std::string why);
  /// The same value, but used where its source does not: with a warning, and not in range.
  Outcome outside(std::string warning) &&;
  /// The same value from an input of doubtful standing, with a warning.
  Outcome in_doubt(std::string warning) &&;

  double value;  // NaN where there is none
  double low;
  double high;
  std::string caution;    // empty, or what to mind
  bool misused = false;   // see outside()
  bool doubtful = false;  // see in_doubt()
};

struct Relation {
  std::string_view name;
  Topic topic;
  Measure measure;
  Standing standing;
  std::string_view formula;
  std::string_view source;
  std::string_view note = "";  // assumptions and corrections; may be empty
  Validity validity;
  bool sea_level_air = false;                   // measured in it; other air: sachs.hpp
  std::string_view needs = "";                  // options without which it does not apply
  bool (*applies)(Situation const&) = nullptr;  // null: always
  Outcome (*evaluate)(Situation const&);
};

/// All relations, by topic in the order of the enum.
std::span<Relation const> relations();

/// Their parts, one file each.
std::span<Relation const> kingery_air_relations();
std::span<Relation const> air_relations();
std::span<Relation const> kingery_surface_relations();
std::span<Relation const> surface_relations();
std::span<Relation const> reflection_relations();
std::span<Relation const> pulse_relations();
std::span<Relation const> line_relations();
std::span<Relation const> ground_relations();  // contact to displacement
std::span<Relation const> crater_relations();
std::span<Relation const> water_relations();  // water and bubble

/// "0.134 to 100 ft/lb^(1/3) (Z = R/W^(1/3))", "no range stated by the source".
std::string describe(Validity const& validity);

}  // namespace moraine::blast
