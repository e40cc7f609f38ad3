// Any text as a value with a unit: a finite number, or a rule that it breaks.
#include <cmath>

#include "base/units.hpp"
#include "fuzzing.hpp"

using namespace moraine;

extern "C" int LLVMFuzzerTestOneInput(unsigned char const* data, std::size_t size) {
  if (size == 0) return 0;
  auto const quantity = static_cast<Quantity>(data[0] % quantity_count);
  Conversion const result = to_si(fuzzing::text_of(data + 1, size - 1), quantity);
  if (result.value)
    fuzzing::require(std::isfinite(*result.value), "a value is finite");
  else
    fuzzing::require(!result.rule.empty(), "what has no value breaks a rule");
  return 0;
}
