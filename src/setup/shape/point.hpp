// Points of a case: three components, those beyond its dimension are zero.
#pragma once

#include "base/vec3.hpp"

namespace moraine {

using Point = Vec3;  // m

}  // namespace moraine
