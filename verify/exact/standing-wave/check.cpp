// A small standing wave: its period and how long it lasts.
#include "verify/check.hpp"

#include <fmt/core.h>

#include <string>
#include <variant>
#include <vector>

#include "verify/shipped_cases.hpp"
#include "verify/wave_decay.hpp"

namespace moraine {
namespace {

/// What artificial viscosity should take from the wave in a period: in 2D it is one of
/// alpha h c / 8 for all pairs (Monaghan, Rep. Prog. Phys. 68 (2005) 1703, section 8.2), and half
/// of the pairs approach.
double loss_by_artificial_viscosity(Case c) {
  Tait const& water = std::get<Tait>(c.materials.front().eos);
  c.materials.front().dynamic_viscosity = water.reference_density * c.numerics.viscosity_alpha *
                                          c.numerics.smoothing_length() *
                                          water.reference_sound_speed / 16.0;
  return exact_wave_loss(c);
}

}  // namespace

std::vector<CheckResult> check_standing_wave(Effort effort) {
  int const periods = effort == Effort::full ? 2 : 1;
  Case const water = shipped_case("standing-wave");
  WaveRun const wave = run_wave(water, periods);
  Case thick = water;
  thick.numerics.physical_viscosity = ViscosityForm::monaghan_cleary;
  thick.materials.front().dynamic_viscosity = 2.0;
  Case rubbed = water;
  rubbed.numerics.viscosity_alpha = 0.1;
  std::string const over = fmt::format("over {} period{}", periods, periods == 1 ? "" : "s");
  return {compare("standing-wave: period", wave.period, 0.0, 0.01, "-",
                  "by that of linear theory, - 1; " + over),
          at_most("standing-wave: loss in a period", wave.loss, 0.01, "-",
                  "logarithm of the amplitude, of which nothing should be lost; " + over),
          at_most("standing-wave: energy", wave.energy_drift, 1e-3, "-",
                  "total energy gained / energy of the wave"),
          compare("standing-wave: loss by viscosity", run_wave(thick, periods).loss,
                  exact_wave_loss(thick), 0.01, "-",
                  "monaghan_cleary, 2 Pa s; 2 nu k^2 T by linear theory"),
          compare("standing-wave: alpha = 0.1 (negative control)", run_wave(rubbed, periods).loss,
                  loss_by_artificial_viscosity(rubbed), 0.05, "-",
                  "loss in a period; that of the viscosity alpha h c / 16")};
}

}  // namespace moraine
