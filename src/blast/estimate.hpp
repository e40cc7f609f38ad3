// Answers: every relation that applies to a situation, with its warnings, and their spread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "blast/relation.hpp"

namespace moraine::blast {

/// What one relation says of a situation, in SI.
struct Estimate {
  Relation const* relation;
  double value;  // NaN where the relation has none: a warning says why
  double low;    // bounds of its own scatter; equal to value where the source states none
  double high;
  double variable;  // of its validity, in that unit; NaN where it has none
  bool in_range;    // false outside its range, where it is not meant for, and without a value
  Standing standing;
  std::vector<std::string> warnings;
};

/// How far relations for one measure lie apart.
struct Spread {
  Measure measure;
  int count;   // relations in range and not doubtful
  double low;  // of their values
  double high;
};

/// A relation that applies to a topic but lacks an input.
struct Unanswered {
  Relation const* relation;
  std::string needs;
};

struct Answer {
  std::vector<Estimate> estimates;  // by measure in the order of the list
  std::vector<Spread> spreads;      // of measures with at least two such relations
  std::vector<Unanswered> unanswered;
};

/// All relations of a topic for a situation. Outside its range a relation still gives its number,
/// which then carries a warning; so do numbers of relations without a stated range, of doubtful
/// standing, or measured in air at sea level and carried over to other air (sachs.hpp).
Answer answer(Topic topic, Situation const& situation);

}  // namespace moraine::blast
