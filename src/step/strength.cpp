// Solids in a step: their stress goes on in time, yields, and pushes.
#include <cmath>

#include "base/parallel_for.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

/// The fields of solids by component.
template <int D>
class SolidFields {
 public:
  SolidFields(ParticleStore& store, Field stress)
      : strain_(store.scalar(Field::plastic_strain)),
        work_(store.scalar(Field::plastic_work)),
        density_(store.scalar(Field::density)) {
    for (int k = 0; k < symmetric_size<D>; ++k) {
      from_[static_cast<std::size_t>(k)] = store.component(Field::deviatoric_stress, k);
      to_[static_cast<std::size_t>(k)] = store.component(stress, k);
    }
    for (int k = 0; k < D * D; ++k)
      gradient_[static_cast<std::size_t>(k)] = store.component(Field::velocity_gradient, k);
  }

  StressState state(std::size_t i) const {
    Symmetric<D> kept{};
    for (std::size_t k = 0; k < kept.size(); ++k) kept[k] = from_[k][i];
    return {.stress = unpacked<D>(kept)};
  }

  Deformation deformation_of(std::size_t i, double dt) const {
    return deformation<D>([&](int k) { return gradient_[static_cast<std::size_t>(k)][i]; }, dt);
  }

  void set_stress(std::size_t i, StressState const& state) const {
    Symmetric<D> const kept = packed<D>(state.stress);
    for (std::size_t k = 0; k < kept.size(); ++k) to_[k][i] = kept[k];
  }

  /// Adds what yielding has done.
  void book(std::size_t i, StressState const& state) const {
    strain_[i] += state.plastic_strain;
    work_[i] += state.plastic_work / density_[i];
  }

 private:
  std::array<std::span<double>, static_cast<std::size_t>(symmetric_size<D>)> from_, to_;
  std::array<std::span<double>, static_cast<std::size_t>(D* D)> gradient_;
  std::span<double> strain_, work_, density_;
};

/// Calls pass(law, particles of it) for each solid material; `particles` empty: all of them.
template <class Pass>
void for_each_solid(Model const& model, std::vector<std::vector<std::uint32_t>> const& by_material,
                    Pass&& pass) {
  bool const one = model.materials.size() == 1;
  std::size_t const all = model.particles.range(Kind::fluid).size();
  for (std::size_t m = 0; m < model.materials.size(); ++m)
    std::visit(
        [&](auto const& law) {
          if constexpr (requires { law.shear_modulus; })
            for_each_block(one ? all : by_material[m].size(), loop_block,
                           [&](std::size_t begin, std::size_t end) {
                             for (std::size_t k = begin; k < end; ++k)
                               pass(law, one ? k : by_material[m][k]);
                           });
        },
        model.materials[m].strength);
}

/// The stress after `dt` at the present pressure and velocity gradient, into the field `to`.
template <int D>
void go_on(Model& model, std::vector<std::vector<std::uint32_t>> const& by_material, Field to,
           double dt) {
  SolidFields<D> const fields(model.particles, to);
  ParticleStore const& store = model.particles;
  auto const pressure = store.scalar(Field::pressure);
  auto const spalled =
      store.has(Field::spalled) ? store.scalar(Field::spalled) : std::span<double const>();
  for_each_solid(model, by_material, [&](auto const& law, std::size_t i) {
    StressState after =
        advance_stress(law, fields.state(i), fields.deformation_of(i, dt), pressure[i]);
    if (!spalled.empty() && spalled[i] > 0.0 && pressure[i] <= 0.0) after = {};
    fields.set_stress(i, after);
    if (to == Field::deviatoric_stress) fields.book(i, after);
  });
}

void go_on(Model& model, std::vector<std::vector<std::uint32_t>> const& by_material, Field to,
           double dt) {
  if (model.dimension == 1) return go_on<1>(model, by_material, to, dt);
  if (model.dimension == 2) return go_on<2>(model, by_material, to, dt);
  go_on<3>(model, by_material, to, dt);
}

}  // namespace

/// What the pair terms see, at the pressure of the predicted density and energy.
void Simulation::predict_stress() {
  if (strength_) go_on(model_, by_material_, Field::predicted_stress, predict_by());
}

/// Half of a step, with the gradient of one of its ends.
void Simulation::advance_stress(double dt) {
  if (strength_) go_on(model_, by_material_, Field::deviatoric_stress, dt);
}

void Simulation::sum_strength() {
  if (!strength_) return;
  StrengthOutcome const outcome = strength_->sweep(model_.particles, search_);
  for (std::size_t axis = 0; axis < 3; ++axis) swept_.wall_force[axis] += outcome.wall_force[axis];
  swept_.wall_power += outcome.wall_power;
}

}  // namespace moraine
