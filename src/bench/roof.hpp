// How fast the pair loop could be: the sweep alone, with nothing around it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "step/model.hpp"

namespace moraine {

/// The pair loop of one state, repeated on the same records and lists.
struct RoofLine {
  std::string name;
  int threads = 1;
  std::uint64_t pairs = 0;       // closer than 2 h, per sweep
  double listed_per_pair = 0.0;  // entries of the lists, padding and skin included, per such pair
  double median_pairs_per_second_per_core = 0.0;
  double fastest_pairs_per_second_per_core = 0.0;
};

/// Sweeps the state of `model` again and again for about `seconds`. One thread: `threads` 1, since
/// small states are one block of work.
RoofLine measure_roof(std::string name, Model model, SchemeName scheme, int threads,
                      double seconds);

/// The lines of `moraine bench roof`: the dam break, whose records and lists lie in memory or the
/// outer cache, beside a periodic block that the second-level cache holds; each with the records
/// of one liquid and with those of any material.
std::vector<RoofLine> measure_roof_lines(int threads, double seconds_each);

std::string roof_table(std::vector<RoofLine> const& lines);

}  // namespace moraine
