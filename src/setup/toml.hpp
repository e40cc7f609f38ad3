// The one way to include toml++, so that a malformed file can neither abort nor mislead it.
#pragma once

// toml++ 3.3 asserts that a table header starts with a key and then handles that it does not, with
// a proper message. "[[<name]]" would end a debug build; with Clang in a release build the
// condition becomes an assumption of the optimiser. Both are switched off.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_assert(true)
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

#include <cassert>  // assert as NDEBUG has it again
