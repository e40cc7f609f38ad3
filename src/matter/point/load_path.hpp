// The tests of a soil laboratory on one point of a material.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "matter/point/material_element.hpp"

namespace moraine {

/// hydrostatic: compressed alike along all axes. uniaxial (oedometer): along x, no strain across.
/// triaxial: along x, the stress across is held. biaxial: along x, the stress along y is held, no
/// strain along z. shear: simple shear, v_x by y, at constant volume.
enum class LoadPath : std::uint8_t { hydrostatic, uniaxial, triaxial, biaxial, shear };
inline constexpr std::array<std::string_view, 5> load_path_names{"hydrostatic", "uniaxial",
                                                                 "triaxial", "biaxial", "shear"};

struct Loading {
  LoadPath path = LoadPath::uniaxial;
  double confinement = 0.0;  // Pa, pressure at the start; what is held across is minus this
  double strain = 0.1;       // at the end: compression along x (along each axis where hydrostatic)
                             // or shear angle; negative: extension
  int steps = 1000;
};

/// The states of all steps, the first one included. Throws std::domain_error where no strain holds
/// the stress across.
std::vector<ElementState> follow(MaterialElement const& point, Loading const& loading);

}  // namespace moraine
