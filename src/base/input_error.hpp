// Mistakes in input files: collected, located, shown together.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace moraine {

/// One mistake. Lines and columns count from 1; line 0 means that no place in the file is known.
struct InputProblem {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
  std::string key;    // full path, "material.tnt.density"
  std::string value;  // as written in the file; empty if the mistake is not about a value
  std::string rule;   // continues the sentence that starts with the value
  std::string hint;   // what to write instead; may be empty
};

/// One line: `file:line:column: key: value rule; hint`, leaving out what is empty.
std::string format(InputProblem const& problem);

/// All mistakes of one input. what() holds one line per mistake, in the order of the file.
class InputErrors : public std::runtime_error {
 public:
  explicit InputErrors(std::vector<InputProblem> problems);
  std::vector<InputProblem> const& problems() const { return problems_; }

 private:
  std::vector<InputProblem> problems_;
};

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance; Damerau, Comm. ACM 7 (1964) 171).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that was probably meant: the first with the least distance if that is at most a third
/// of the longer length (at least one), or else the first that `word` abbreviates or extends by
/// whole words. Names of one or two letters are never near each other. Empty if none is near.
std::string_view nearest_name(std::string_view word, std::span<std::string_view const> names);

/// Ready hint: `did you mean "x"?`, else `choose one of "a", "b"`; empty without names.
std::string name_hint(std::string_view word, std::span<std::string_view const> names);

}  // namespace moraine
