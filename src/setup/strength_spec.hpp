// How a solid resists shear, as the case file says it.
#pragma once

#include <cstdint>
#include <optional>

namespace moraine {

/// In the order of the list Strength.
enum class StrengthKind : std::uint8_t { none, elastic, von_mises, drucker_prager, mohr_coulomb };

/// Constants of matter/strength; which of them a kind has is checked, and none has a default.
struct StrengthSpec {
  StrengthKind kind = StrengthKind::none;
  std::optional<double> shear_modulus{};   // Pa
  std::optional<double> yield_strength{};  // Pa
  std::optional<double> yield_slope{};     // -
  std::optional<double> shear_strength{};  // Pa
  std::optional<double> friction_angle{};  // rad
  std::optional<double> cohesion{};        // Pa
};

}  // namespace moraine
