// The table of parameters as a JSON Schema, for completion and checks in editors.
#pragma once

#include <string>

namespace moraine {

/// A JSON Schema (draft 2020-12) of case files, with a newline at its end. Whatever `read_case`
/// accepts, the schema accepts. It refuses unknown and missing keys, wrong types, unknown names and
/// plain numbers out of range; it does not know units beyond "a number and a text behind it", the
/// dimension, or rules between keys.
std::string json_schema();

}  // namespace moraine
