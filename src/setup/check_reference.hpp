// Rules between the keys of a reference value, and its file.
#pragma once

#include <string>

#include "setup/case.hpp"
#include "setup/source.hpp"

namespace moraine {

/// Reports a gauge that is not there, a value beside a file or neither, a tolerance without a
/// value, an arrival that no pressure defines, and a file that cannot be read. Afterwards `file` is
/// absolute. `key`: "reference.NAME".
void check_reference(Case const& c, ReferenceSpec& reference, std::string const& key,
                     Source& source);

}  // namespace moraine
