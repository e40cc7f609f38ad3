// The matter of a step: pressure and sound speed of all particles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/parallel_for.hpp"
#include "step/bad_particles.hpp"
#include "step/compaction.hpp"
#include "step/simulation.hpp"

namespace moraine {
namespace {

/// What a particle that burns answers; notes how far it has burnt by then.
template <class Law>
auto burning(Law const& law, ProgrammedBurn const& burn, ParticleStore& store, double now) {
  return [&law, &burn, now, burnt = store.scalar(Field::burn_fraction),
          lit = store.scalar(Field::lighting_time)](std::size_t i, double rho, double e) {
    burnt[i] = burn.fraction(burnt[i], rho, now - lit[i]);
    return burn.respond(law, rho, e, burnt[i]);
  };
}

/// Lets material part at its least pressure, for good: what has parted has no tension.
template <class Law>
void part(Law const& law, bool spalls, std::span<double> spalled, std::size_t i,
          StateResponse& state) {
  if constexpr (requires { law.least_pressure; }) {
    if (!spalls) return;
    if (state.pressure <= law.least_pressure) spalled[i] = 1.0;
    if (spalled[i] > 0.0) state.pressure = std::max(state.pressure, 0.0);
  }
}

/// Speed of the compression waves of a solid, sqrt(c^2 + 4 G / (3 rho)); a state without a sound
/// speed stays one.
double with_shear(double sound_speed, double stiffness) {
  return stiffness > 0.0 && sound_speed >= 0.0 ? std::sqrt(sound_speed * sound_speed + stiffness)
                                               : sound_speed;
}

}  // namespace

void Simulation::sort_by_material() {
  by_material_.resize(model_.materials.size());
  if (model_.materials.size() == 1) return;  // all of them, in order
  for (auto& indices : by_material_) indices.clear();
  Range const fluid = model_.particles.range(Kind::fluid);
  for (std::size_t i = fluid.begin; i < fluid.end; ++i)
    by_material_[model_.particles.material()[i]].push_back(static_cast<std::uint32_t>(i));
}

/// No particle loses more than a share of its density in a step, at the present rates.
Vote Simulation::vote_of_expansion() const {
  if (!density_is_state() || model_.time.fixed_step > 0.0) return {};
  ParticleStore const& store = model_.particles;
  if (store.range(Kind::fluid).size() == 0) return {};
  auto const density = store.scalar(Field::density);
  auto const rate = store.scalar(Field::density_rate);
  struct Fastest {
    double share = 0.0;  // of its density that a particle loses [1/s]
    std::size_t particle = 0;
  };
  auto const of_block = [&](std::size_t begin, std::size_t end) {
    Fastest fastest;
    for (std::size_t i = begin; i < end; ++i)
      if (double const share = -rate[i] / density[i]; share > fastest.share) fastest = {share, i};
    return fastest;
  };
  Fastest const fastest =
      reduce_blocks(store.range(Kind::fluid).size(), Fastest{}, of_block,
                    [](Fastest a, Fastest b) { return b.share > a.share ? b : a; });
  return {largest_expansion_of_step / fastest.share, expansion_limit, store.id()[fastest.particle]};
}

void Simulation::evaluate_matter() {
  ParticleStore& store = model_.particles;
  auto const density = store.scalar(Field::density);
  auto const density_rate = store.scalar(Field::density_rate);
  auto const energy = store.scalar(Field::specific_energy);
  auto const energy_rate = store.scalar(Field::energy_rate);
  auto pressure = store.scalar(Field::pressure);
  auto sound_speed = store.scalar(Field::sound_speed);
  double const ahead = predict_by();
  double const density_ahead = density_is_state() ? ahead : 0.0;
  double const now = time_ + vote_.time_step;  // of the predicted state
  double shear = 0.0;                          // 4/3 G of the material [Pa]
  bool spalls = false;
  auto const spalled =
      store.has(Field::spalled) ? store.scalar(Field::spalled) : std::span<double>();
  auto const pass = [&](auto const& law, auto&& respond, std::size_t count, auto&& index) {
    for_each_block(count, loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        std::size_t const i = index(k);
        double const rho = density[i] + density_ahead * density_rate[i];
        StateResponse state = respond(i, rho, energy[i] + ahead * energy_rate[i]);
        part(law, spalls, spalled, i, state);
        pressure[i] = state.pressure;
        sound_speed[i] = with_shear(state.sound_speed, shear / rho);
      }
    });
  };
  auto const pass_material = [&](std::size_t m, auto const& law, auto&& respond) {
    if (model_.materials.size() == 1)
      pass(law, respond, store.range(Kind::fluid).size(), [](std::size_t k) { return k; });
    else
      pass(law, respond, by_material_[m].size(), [&](std::size_t k) { return by_material_[m][k]; });
  };
  for (std::size_t m = 0; m < model_.materials.size(); ++m) {
    auto const& burn = model_.materials[m].burn;
    shear = 4.0 / 3.0 * shear_modulus(model_.materials[m].strength);
    spalls = model_.materials[m].spalls;
    std::visit(
        [&](auto const& law) {
          if constexpr (is_products<std::decay_t<decltype(law)>>)
            if (burn) return pass_material(m, law, burning(law, burn->law, store, now));
          if constexpr (is_compactable<std::decay_t<decltype(law)>>)
            return pass_material(m, law, compacting(law, store));
          else
            pass_material(
                m, law, [&law](std::size_t, double rho, double e) { return law.respond(rho, e); });
        },
        model_.materials[m].eos);
  }
  std::size_t const count = store.range(Kind::fluid).size();
  auto const silent = [&](std::size_t i) { return !(sound_speed[i] >= 0.0); };
  if (first_bad(count, silent) == none) return;
  fail({Guard::state, all_bad(count, silent), [&](std::size_t i) {
          std::string cause = fmt::format(
              "the equation of state gives no sound speed (c^2 < 0) at density {} kg/m^3, "
              "specific energy {} J/kg",
              density[i], energy[i]);
          double const limit = limiting_density(model_.materials[store.material()[i]].eos);
          if (density[i] + density_ahead * density_rate[i] >= limit)
            cause += fmt::format(
                "; no shock reaches the density {:.6g} kg/m^3 (1 / hugoniot_slope)", limit);
          return cause;
        }});
}

}  // namespace moraine
