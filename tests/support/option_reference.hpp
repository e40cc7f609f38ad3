// The optional pair terms written plainly: all pairs of a small model, in scalar double.
#pragma once

#include <array>
#include <vector>

#include "step/model.hpp"
#include "step/simulation_setup.hpp"

namespace moraine {

/// Rates of a model by the main sweep and the optional terms; its particles are sorted on the way.
void find_rates(Model& model);

/// A neighbour of a fluid particle, by the nearest of its periodic images.
struct PlainPair {
  std::size_t j = 0;  // index in the store
  bool wall = false;
  std::array<double, 3> x{};  // x_ij [m]
  double h = 0.0;             // m, of the pair
  double kernel = 0.0;        // W_ij
  double gradient = 0.0;      // grad_i W_ij = gradient * x
};

/// Pairs of fluid particle i, closer than their support, itself left out.
std::vector<PlainPair> plain_pairs(Model const& model, std::size_t i);

/// W(0) at the smoothing length of particle i.
double plain_central_kernel(Model const& model, std::size_t i);

/// h of particle i [m].
double plain_smoothing(Model const& model, std::size_t i);

/// x . (v_i - v_j) with what a fluid pair has in the store.
double plain_approach(Model const& model, std::size_t i, PlainPair const& pair);

using Matrix = std::array<std::array<double, 3>, 3>;

/// - sum_j V_j x_ij (x) grad_i W_ij over fluid and walls, or over fluid of one reference density.
Matrix plain_moments(Model const& model, std::size_t i, bool of_one_material);

/// Inverse of the upper left d x d part, by elimination.
Matrix inverse(Matrix const& m, int dimension);

}  // namespace moraine
