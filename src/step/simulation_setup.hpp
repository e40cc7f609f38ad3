// From a model to what the search and the pair loops need.
#pragma once

#include <vector>

#include "search/search.hpp"
#include "step/model.hpp"
#include "terms/strength/strength_backend.hpp"

namespace moraine {

SearchSettings search_settings(Model const& model);
SweepParameters sweep_parameters(Model const& model);
std::vector<double> reference_densities(Model const& model);

OptionParameters option_parameters(Model const& model);

/// The backend of the optional terms; none where the model asks for no option.
std::unique_ptr<OptionBackend> make_options_of(Model const& model);

/// The backend of solids; none where no material has a strength.
std::unique_ptr<StrengthBackend> make_strength_of(Model const& model);

/// Step that physical viscosity bears, in h^2 / nu: 0.6 / (2 d K), the time in which a particle
/// comes to rest among its neighbours, K of smoothing/viscous_stiffness.hpp; a third of it for the
/// form along x_ij, which wears down compression three times as fast as shear. The predictor is
/// stable below 0.71 to 1.4 in place of 0.6: measured in boxes in 1D to 3D, even and disordered, h
/// of 1.2 to 2 spacings, with six kernels. For Wendland C2 in 2D it is 0.092; Morris, Fox & Zhu, J.
/// Comput. Phys. 136 (1997) 214, eq. 31, have 0.125 for the quintic spline, whose h is smaller.
double viscous_share(Numerics const& numerics, int dimension);

/// `liquid` when all particles are one Tait liquid of equal masses, `compressible` otherwise.
SchemeName scheme_of(Model const& model);

}  // namespace moraine
