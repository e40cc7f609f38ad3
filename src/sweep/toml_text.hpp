// TOML as text again.
#pragma once

#include <string>

#include "setup/toml.hpp"

namespace moraine {

/// A value as TOML on one line. Numbers are the shortest text that reads back to the same bits.
std::string value_text(toml::node const& node);

/// A table as a file. Keys stand in the order of the text that the table was read from, which
/// matters for materials; those that came from no text follow behind. Comments are not kept.
std::string file_text(toml::table const& table);

}  // namespace moraine
