// The list of optional pair terms.
#pragma once

#include <tuple>

#include "terms/options/corrected_gradient.hpp"
#include "terms/options/gradient_diffusion.hpp"
#include "terms/options/option_parameters.hpp"
#include "terms/options/penalty.hpp"
#include "terms/options/physical_viscosity.hpp"
#include "terms/options/velocity_averaging.hpp"
#include "terms/sweep_parameters.hpp"

namespace moraine {

/// All of them, built for a number type; each looks whether it is on.
template <class Real>
auto option_terms(SweepParameters const& sweep, OptionParameters const& options) {
  return std::tuple{PhysicalViscosity<Real>{options.viscosity},
                    VelocityAveraging<Real>{number<Real>(options.xsph), options.xsph > 0.0},
                    Penalty<Real>{number<Real>(options.penalty_strength),
                                  number<Real>(options.penalty_range), options.penalty_repulsion,
                                  options.penalty_attraction, options.penalty_strength > 0.0},
                    GradientDiffusion<Real>{number<Real>(options.gradient_diffusion),
                                            options.gradient_diffusion > 0.0},
                    CorrectedGradient<Real>{options.corrected_gradient, sweep.mixed_momentum,
                                            sweep.volume_continuity}};
}

}  // namespace moraine
