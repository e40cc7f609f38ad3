// The optional terms by their formulas, written plainly over all pairs of a small model.
#pragma once

#include <array>

#include "support/option_reference.hpp"

namespace moraine {

/// What an option adds to one particle.
struct Rates {
  std::array<double, 3> acceleration{}, drift{};
  double density_rate = 0.0;
  double energy_rate = 0.0;
};

/// What each adds to fluid particle i, with the constants that option_terms_test.cpp gives.
Rates plain_morris(Model const& m, std::size_t i);
Rates plain_cleary(Model const& m, std::size_t i);
Rates plain_xsph(Model const& m, std::size_t i);
Rates plain_penalty(Model const& m, std::size_t i);
Rates plain_diffusion(Model const& m, std::size_t i);
Rates plain_correction(Model const& m, std::size_t i);
Rates plain_shifting(Model const& m, std::size_t i);

}  // namespace moraine
