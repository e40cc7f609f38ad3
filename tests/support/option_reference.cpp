#include "support/option_reference.hpp"

#include <cmath>
#include <utility>

#include "smoothing/any_kernel.hpp"
#include "smoothing/pair_smoothing.hpp"

namespace moraine {
namespace {

struct KernelValues {
  double kernel, gradient;
};

template <int D>
KernelValues kernel_at(KernelName name, double r, double h) {
  AnyKernel<D> const kernel(name);
  double const scale = kernel.sigma / std::pow(h, D);
  return {scale * kernel.shape(r / h), scale / (h * h) * kernel.slope_over_q(r / h)};
}

KernelValues kernel_at(Model const& model, double r, double h) {
  KernelName const name = model.numerics.kernel;
  if (model.dimension == 1) return kernel_at<1>(name, r, h);
  return model.dimension == 2 ? kernel_at<2>(name, r, h) : kernel_at<3>(name, r, h);
}

}  // namespace

double plain_smoothing(Model const& model, std::size_t i) {
  return model.particles.has(Field::smoothing_length)
             ? model.particles.scalar(Field::smoothing_length)[i]
             : model.numerics.smoothing_length();
}

double plain_central_kernel(Model const& model, std::size_t i) {
  return kernel_at(model, 0.0, plain_smoothing(model, i)).kernel;
}

void find_rates(Model& model) {
  Search search(search_settings(model));
  search.refresh(model.particles);
  auto const pairs = make_pair_backend(model.dimension, model.flavour(), scheme_of(model),
                                       sweep_parameters(model), reference_densities(model));
  pairs->gather_fluid(model.particles, search, 0.0);
  pairs->gather_walls(model.particles, search, model.walls);
  pairs->sweep(model.particles, search);
  auto const options = make_options_of(model);
  options->gather(model.particles, search, model.walls, 0.0);
  options->sweep(model.particles, search);
}

std::vector<PlainPair> plain_pairs(Model const& model, std::size_t i) {
  ParticleStore const& store = model.particles;
  std::size_t const fluid = store.range(Kind::fluid).size();
  double const h_case = model.numerics.smoothing_length();
  std::vector<PlainPair> pairs;
  for (std::size_t j = 0; j < store.size(); ++j) {
    if (j == i) continue;
    PlainPair pair{j, j >= fluid};
    double square = 0.0;
    for (int axis = 0; axis < model.dimension; ++axis) {
      auto const k = static_cast<std::size_t>(axis);
      auto const x = store.component(Field::position, axis);
      pair.x[k] = x[i] - x[j];
      double const period = model.domain_max[k] - model.domain_min[k];
      if (model.periodic[k]) pair.x[k] -= period * std::round(pair.x[k] / period);
      square += pair.x[k] * pair.x[k];
    }
    double const own = plain_smoothing(model, i);
    pair.h = pair.wall
                 ? std::max(own, h_case)
                 : pair_smoothing(model.numerics.smoothing.of_pair, own, plain_smoothing(model, j));
    double const r = std::sqrt(square);
    if (r >= 2.0 * pair.h) continue;
    KernelValues const values = kernel_at(model, r, pair.h);
    pair.kernel = values.kernel;
    pair.gradient = values.gradient;
    pairs.push_back(pair);
  }
  return pairs;
}

double plain_approach(Model const& model, std::size_t i, PlainPair const& pair) {
  double sum = 0.0;
  for (int axis = 0; axis < model.dimension; ++axis) {
    auto const v = model.particles.component(Field::velocity, axis);
    sum += pair.x[static_cast<std::size_t>(axis)] * (v[i] - (pair.wall ? 0.0 : v[pair.j]));
  }
  return sum;
}

Matrix plain_moments(Model const& model, std::size_t i, bool of_one_material) {
  ParticleStore const& store = model.particles;
  double const lattice_volume = std::pow(model.numerics.spacing, model.dimension);
  Matrix m{};
  for (PlainPair const& pair : plain_pairs(model, i)) {
    if (of_one_material && (pair.wall || store.material()[pair.j] != store.material()[i])) continue;
    double const volume =
        pair.wall ? lattice_volume
                  : store.scalar(Field::mass)[pair.j] / store.scalar(Field::density)[pair.j];
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) m[a][b] -= volume * pair.x[a] * pair.x[b] * pair.gradient;
  }
  return m;
}

Matrix inverse(Matrix const& m, int dimension) {
  Matrix left = m;
  Matrix right{};
  auto const n = static_cast<std::size_t>(dimension);
  for (std::size_t a = 0; a < n; ++a) right[a][a] = 1.0;
  for (std::size_t c = 0; c < n; ++c) {
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::fabs(left[r][c]) > std::fabs(left[c][c])) {
        std::swap(left[r], left[c]);
        std::swap(right[r], right[c]);
      }
    double const pivot = left[c][c];
    for (std::size_t k = 0; k < n; ++k) {
      left[c][k] /= pivot;
      right[c][k] /= pivot;
    }
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      double const factor = left[r][c];
      for (std::size_t k = 0; k < n; ++k) {
        left[r][k] -= factor * left[c][k];
        right[r][k] -= factor * right[c][k];
      }
    }
  }
  return right;
}

}  // namespace moraine
