// The settings of a case as a list, for those who show them.
#pragma once

#include <string>
#include <vector>

#include "setup/case.hpp"

namespace moraine {

/// One key of a case with its value.
struct Setting {
  std::string section;  // "resolution", "material tnt", "region charge"; "" for keys of the case
  std::string key;      // inside its section
  std::string value;    // as in a case file, SI
  std::string unit;     // of the value; empty for what has none
  bool is_default = false;
  std::string meaning;
};

/// All settings of a case in the order of the reference page, defaults included.
std::vector<Setting> settings_of(Case const& c);

}  // namespace moraine
