// What exact solutions ask of a material.
#pragma once

#include <functional>
#include <utility>
#include <variant>

#include "matter/eos/eos.hpp"

namespace moraine {

/// Any type with pressure(rho, e) and sound_speed_squared(rho, e): the laws of the list Eos, and
/// laws that only a comparison needs.
template <class T>
concept PressureLaw = requires(T const& law, double rho, double e) {
  { law.pressure(rho, e) } -> std::convertible_to<double>;
  { law.sound_speed_squared(rho, e) } -> std::convertible_to<double>;
};

/// Pressure [Pa] and squared sound speed [m^2/s^2] of density rho [kg/m^3] and specific energy
/// e [J/kg]. Made of an Eos or of any PressureLaw. Exact solutions are set up once and looked at a
/// few thousand times: the indirect call costs nothing that matters, and one compiled solver serves
/// all laws.
class Law {
 public:
  template <PressureLaw T>
  requires(!std::same_as<T, Law>) Law(T law)  // NOLINT(google-explicit-constructor): a law is a Law
      : pressure_([law](double rho, double e) { return law.pressure(rho, e); }),
        sound_speed_squared_(
            [law](double rho, double e) { return law.sound_speed_squared(rho, e); }) {}

  Law(Eos const& eos)  // NOLINT(google-explicit-constructor): the same
      : Law(std::visit([](auto const& law) { return Law(law); }, eos)) {}

  double pressure(double rho, double e) const { return pressure_(rho, e); }
  double sound_speed_squared(double rho, double e) const { return sound_speed_squared_(rho, e); }
  /// Negative where the state has none, like those of the laws.
  double sound_speed(double rho, double e) const {
    return signed_root(sound_speed_squared_(rho, e));
  }

 private:
  std::function<double(double, double)> pressure_;
  std::function<double(double, double)> sound_speed_squared_;
};

}  // namespace moraine
