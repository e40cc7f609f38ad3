// From a model to what the search and the pair loops need.
#pragma once

#include <vector>

#include "search/search.hpp"
#include "step/model.hpp"

namespace moraine {

SearchSettings search_settings(Model const& model);
SweepParameters sweep_parameters(Model const& model);
std::vector<double> reference_densities(Model const& model);

/// `liquid` when all particles are one Tait liquid of equal masses, `compressible` otherwise.
OptionParameters option_parameters(Model const& model);

/// The backend of the optional terms; none where the model asks for no option.
std::unique_ptr<OptionBackend> make_options_of(Model const& model);

SchemeName scheme_of(Model const& model);

}  // namespace moraine
