#include "verify/random_box.hpp"

#include <cmath>
#include <random>

namespace moraine {
namespace {

constexpr double spacing = 0.01;           // m
constexpr double reference_speed = 100.0;  // m/s, of sound

Tait liquid(double density) {
  Tait law;
  law.reference_density = density;
  law.reference_sound_speed = reference_speed;
  return law;
}

/// Uniform in [-1, 1). Standard distributions differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return std::ldexp(static_cast<double>(engine_() >> 11), -52) - 1.0; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace

Model random_box(RandomBox const& box, double end) {
  Model model;
  auto const axes = static_cast<std::size_t>(box.dimension);
  double const edge = box.side * spacing;
  model.dimension = box.dimension;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    model.domain_max[axis] = edge;
    model.periodic[axis] = true;
  }
  model.numerics.spacing = spacing;
  model.numerics.precision = box.precision;
  model.time.end = end;
  model.materials = {{"light", liquid(1000.0)}};
  bool const two = box.scheme != SchemeName::liquid;
  if (two) model.materials.push_back({"heavy", liquid(3000.0)});
  for (Material& material : model.materials) material.penalty_group = material.name;
  model.particles = ParticleStore(box.dimension);
  ParticleStore& store = model.particles;
  Dice dice(box.seed);
  auto const count = static_cast<std::size_t>(std::lround(std::pow(box.side, box.dimension)));
  for (std::size_t n = 0; n < count; ++n) {
    auto rest = static_cast<int>(n);
    bool const heavy = two && rest % box.side >= box.side / 2;
    std::size_t const i = store.append(Kind::fluid, heavy ? 1 : 0);
    for (int axis = 0; axis < box.dimension; ++axis) {
      store.component(Field::position, axis)[i] =
          spacing * (rest % box.side + 0.5 + box.displacement * dice());
      store.component(Field::velocity, axis)[i] = box.velocity * reference_speed * dice();
      rest /= box.side;
    }
    double const density = heavy ? 3000.0 : 1000.0;
    store.scalar(Field::density)[i] = density * (1.0 + 0.01 * dice());
    store.scalar(Field::mass)[i] = density * std::pow(spacing, box.dimension);
  }
  if (box.scheme == SchemeName::variable) {
    model.numerics.smoothing.mode = SmoothingMode::density;
    store.use(Field::smoothing_length);
    for (double& h : store.scalar(Field::smoothing_length))
      h = model.numerics.smoothing_length() * (1.0 + 0.3 * dice());
  }
  return model;
}

}  // namespace moraine
