// What `moraine check` tells about a case without mistakes: its size, its cost, and what is
// doubtful.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "setup/case.hpp"

namespace moraine {

struct CaseReport {
  struct Count {
    std::string material;
    std::size_t particles = 0;
  };
  std::vector<Count> fluid;       // by material, in the order of the case
  std::size_t walls = 0;          // wall particles
  double bytes = 0.0;             // memory of a run, from measured bytes per particle
  double time_step = 0.0;         // s, voted at the start
  std::string limited_by;         // who asked for that step
  double steps = 0.0;             // until the end, if all were as long as the first
  double seconds_per_step = 0.0;  // measured here, with the threads in use
  int timed_steps = 0;            // how many steps were timed for that
  std::vector<InputProblem> warnings;

  double wall_time() const { return steps * seconds_per_step; }  // s, without output
};

/// Builds the model in memory, makes some steps (about half a second, two at least) and looks at
/// the start. Throws InputErrors for mistakes that only the model shows. Writes nothing.
CaseReport report_case(Case const& c);

/// The report as lines of text, and as a JSON object.
std::string to_text(CaseReport const& report);
std::string to_json(CaseReport const& report);

/// Mistakes as the JSON object that stands for a case that has them.
std::string mistakes_to_json(InputErrors const& errors);

}  // namespace moraine
