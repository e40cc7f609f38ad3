// Where things stand in a case file, and what is wrong with them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_error.hpp"
#include "setup/case.hpp"

namespace moraine {

/// A stretch of the text: lines and columns count from 1, columns in characters; line 0: nowhere.
struct Stretch {
  std::size_t line = 0;
  std::size_t column = 0;
  std::size_t end_line = 0;
  std::size_t end_column = 0;  // one beyond the last character
};

/// The text of a case file, the places of its keys, and the mistakes found so far.
class Source {
 public:
  Source(std::string_view text, std::string_view file);

  std::string const& file() const { return file_; }
  std::vector<InputProblem> const& problems() const { return problems_; }

  /// Notes that `key` has its value at this place.
  void remember(std::string const& key, Stretch place) { places_[key] = place; }

  /// Where the value of a key stands; nowhere if it was not remembered.
  Stretch place_of(std::string const& key) const {
    auto const found = places_.find(key);
    return found != places_.end() ? found->second : Stretch{};
  }

  /// All remembered keys; the text is left out where it is a whole table.
  std::map<std::string, Place> places() const;

  /// Whether the file holds the key, and no mistake was reported for it.
  bool has(std::string const& key) const { return places_.contains(key); }
  bool good(std::string const& key) const { return has(key) && !bad_.contains(key); }

  bool has_problem(std::string const& key) const { return bad_.contains(key); }

  /// Reports a mistake of the value at `place`, quoted as it is written there.
  void report_value(std::string const& key, Stretch place, std::string rule, std::string hint = {});

  /// Reports a mistake of the remembered value of a key.
  void report_value(std::string const& key, std::string rule, std::string hint = {});

  /// Reports a mistake about a key itself, such as one that is missing or unknown.
  void report_key(std::string const& key, Stretch place, std::string rule, std::string hint = {});

 private:
  std::string excerpt(Stretch place) const;

  std::string file_;
  std::vector<std::string> lines_;
  std::map<std::string, Stretch> places_;
  std::set<std::string> bad_;
  std::vector<InputProblem> problems_;
};

}  // namespace moraine
