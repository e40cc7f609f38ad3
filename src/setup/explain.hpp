// What a key of the case file means, from the table of parameters.
#pragma once

#include <string>
#include <string_view>

namespace moraine {

/// Meaning, unit, default, range, source and an example of a key; for a table the list of its keys.
/// A key may be written as in messages ("material.tnt.a1", "region[2].velocity"), with NAME for the
/// name, or without ("material.a1"). An empty key lists all tables. Throws InputErrors with the
/// nearest names for what is no key.
std::string explain(std::string_view key);

/// The page docs/reference.md: all keys, quantities and shipped materials, as Markdown.
std::string reference_page();

}  // namespace moraine
