// Exact solutions for liquids: channel flows, vortices, a standing wave.
#include <cmath>

#include "app/exact_profile.hpp"
#include "app/exact_solution.hpp"
#include "exact/channel_flow.hpp"
#include "exact/standing_wave.hpp"
#include "exact/taylor_green.hpp"

namespace moraine {
namespace {

constexpr char const* morris = "Morris, Fox and Zhu, J. Comput. Phys. 136 (1997) 214";
constexpr Dimension viscosity{"a kinematic viscosity", "m^2/s", {"m^2/s", "mm^2/s", "cm^2/s"}};

ExactParameter viscosity_parameter(std::string_view fallback, ExactRange range) {
  return {"kinematic_viscosity",
          fallback,
          "of the liquid",
          ExactValueKind::number,
          viscosity,
          range,
          {}};
}

ExactParameter time_parameter(std::string_view fallback) {
  return exact_number("time", fallback, Quantity::time, ExactRange::not_negative, "time");
}

ExactParameter length(std::string_view key, std::string_view fallback, std::string_view meaning) {
  return exact_number(key, fallback, Quantity::length, ExactRange::positive, meaning);
}

template <class Flow>
ExactAnswer channel_answer(Flow const& flow, ExactValues const& values) {
  flow.check();
  double const t = values.number("time"), width = flow.width;
  ExactAnswer answer;
  answer.profile = table_of({{"y", "m"}, {"velocity", "m/s"}, {"steady_velocity", "m/s"}});
  for (double const y : even_steps(0.0, width, values.points))
    add_row(answer.profile, {y, flow.velocity(y, t), flow.steady_velocity(y)});
  answer.numbers = {
      {"velocity in the middle", flow.velocity(0.5 * width, t), "m/s"},
      {"steady velocity in the middle", flow.steady_velocity(0.5 * width), "m/s"},
      {"time scale, width^2/viscosity", width * width / flow.kinematic_viscosity, "s"}};
  return answer;
}

ExactAnswer solve_couette(ExactValues const& values) {
  return channel_answer(CouetteFlow{values.number("width"), values.number("kinematic_viscosity"),
                                    values.number("plate_speed")},
                        values);
}

ExactAnswer solve_poiseuille(ExactValues const& values) {
  return channel_answer(PoiseuilleFlow{values.number("width"), values.number("kinematic_viscosity"),
                                       values.number("force")},
                        values);
}

ExactAnswer solve_taylor_green(ExactValues const& values) {
  TaylorGreen const flow{values.number("length"), values.number("kinematic_viscosity"),
                         values.number("speed"), values.number("density")};
  flow.check();
  double const t = values.number("time");
  ExactAnswer answer;
  answer.profile =
      table_of({{"x", "m"}, {"velocity_x", "m/s"}, {"velocity_y", "m/s"}, {"pressure", "Pa"}});
  for (double const x : even_steps(0.0, flow.length, values.points)) {
    auto const at = flow.sample(x, values.number("y"), t);
    add_row(answer.profile, {x, at.velocity_x, at.velocity_y, at.pressure});
  }
  answer.numbers = {{"decay rate of velocities", flow.decay_rate(), "1/s"},
                    {"largest speed", flow.speed * std::exp(-flow.decay_rate() * t), "m/s"},
                    {"mean kinetic energy", flow.mean_energy(t), "J/m^3"},
                    {"mean kinetic energy at first", flow.mean_energy(0.0), "J/m^3"}};
  return answer;
}

ExactAnswer solve_standing_wave(ExactValues const& values) {
  StandingWave const wave{values.number("wave_length"),         values.number("depth"),
                          values.number("amplitude"),           values.number("gravity"),
                          values.number("kinematic_viscosity"), values.number("density")};
  wave.check();
  double const t = values.number("time");
  ExactAnswer answer;
  answer.profile =
      table_of({{"x", "m"}, {"elevation", "m"}, {"velocity_x", "m/s"}, {"velocity_z", "m/s"}});
  for (double const x : even_steps(0.0, wave.wave_length, values.points)) {
    auto const at = wave.sample(x, 0.0, t);
    add_row(answer.profile, {x, wave.elevation(x, t), at.velocity_x, at.velocity_z});
  }
  answer.numbers = {{"angular frequency", wave.angular_frequency(), "rad/s"},
                    {"period", wave.period(), "s"},
                    {"phase speed", wave.angular_frequency() / wave.wave_number(), "m/s"},
                    {"decay rate of the amplitude", wave.decay_rate(), "1/s"},
                    {"elevation at x = 0", wave.elevation(0.0, t), "m"},
                    {"energy of a wave length at first", wave.energy(), "J/m"}};
  return answer;
}

}  // namespace

std::vector<ExactSolution> exact_liquid_solutions() {
  ExactParameter const width = length("width", "1 mm", "between the plates");
  ExactParameter const viscous = viscosity_parameter("1e-6 m^2/s", ExactRange::positive);
  ExactParameter const density = exact_number("density", "1000 kg/m^3", Quantity::density,
                                              ExactRange::positive, "of the liquid");
  return {
      {"couette",
       "start-up of the flow between a plate at rest, y = 0, and one that moves",
       morris,
       {width, viscous,
        exact_number("plate_speed", "12.5 um/s", Quantity::velocity, ExactRange::any,
                     "of the plate y = width"),
        time_parameter("0.1 s")},
       solve_couette},
      {"poiseuille",
       "start-up of the flow between two plates under a force per mass",
       morris,
       {width, viscous,
        exact_number("force", "1e-4 m/s^2", Quantity::acceleration, ExactRange::any,
                     "per mass, along the plates"),
        time_parameter("0.1 s")},
       solve_poiseuille},
      {"taylor-green",
       "decaying vortices in a periodic square; profile along x",
       "Taylor and Green, Proc. R. Soc. Lond. A 158 (1937) 499",
       {length("length", "1 m", "of the square"),
        viscosity_parameter("0.01 m^2/s", ExactRange::not_negative),
        exact_number("speed", "1 m/s", Quantity::velocity, ExactRange::any, "largest, at first"),
        exact_number("density", "1 kg/m^3", Quantity::density, ExactRange::positive,
                     "of the liquid"),
        exact_number("y", "0.125 m", Quantity::length, ExactRange::any, "of the profile"),
        time_parameter("1 s")},
       solve_taylor_green},
      {"standing-wave",
       "small standing wave on a liquid; profile along the surface at rest",
       "Lamb, Hydrodynamics, 6th ed. (1932), arts. 228, 348",
       {length("wave_length", "2 m", "twice the length of a tank in its first mode"),
        length("depth", "1 m", "of the liquid"),
        length("amplitude", "1 cm", "of the surface, much less than the wave length"),
        exact_number("gravity", "9.81 m/s^2", Quantity::acceleration, ExactRange::positive,
                     "downwards"),
        viscosity_parameter("0 m^2/s", ExactRange::not_negative), density, time_parameter("0 s")},
       solve_standing_wave}};
}

}  // namespace moraine
