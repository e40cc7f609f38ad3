// The pair backend as a template; instantiated from the list in pair_backends_*.cpp only.
#pragma once

#include <optional>

#include "smoothing/pair_smoothing.hpp"
#include "terms/gather_fluid.hpp"
#include "terms/gather_walls.hpp"
#include "terms/mirror_loads.hpp"
#include "terms/pair_backend.hpp"
#include "terms/pair_records.hpp"
#include "terms/reference_sweep.hpp"
#include "terms/schemes.hpp"
#include "terms/sweep.hpp"
#include "terms/wall_loads.hpp"

namespace moraine {

template <int D, Flavour flavour, class Kernel, class Scheme>
class PairBackendImpl final : public PairBackend {
  using Pairs = PairRecords<D, flavour, Kernel, Scheme>;
  using Real = typename Pairs::Real;
  using FluidLayout = typename Pairs::FluidLayout;
  using WallLayout = typename Pairs::WallLayout;
  using Number = typename Pairs::Number;

 public:
  PairBackendImpl(SweepParameters const& parameters, std::vector<double> reference_densities)
      : pairs_(parameters, std::move(reference_densities)) {}

  void gather_fluid(ParticleStore const& store, Search const& search, double ahead) override {
    gather_fluid_records(pairs_, store, search, ahead);
  }

  void gather_walls(ParticleStore& store, Search const& search, WallData const& walls) override {
    if (rebuilds_seen_ != search.rebuilds()) {
      rebuilds_seen_ = search.rebuilds();
      place_walls(pairs_, store, search, walls);
    }
    gather_wet_walls(pairs_, store, search, walls);
  }

  SweepOutcome sweep(ParticleStore& store, Search const& search) override {
    auto const swept = [&](std::size_t begin, std::size_t end) {
      return sweep_block(store, search, begin, end);
    };
    auto const combine = [](SweepOutcome a, SweepOutcome const& b) {
      a.include(b.signal_speed, b.particle);
      for (std::size_t axis = 0; axis < 3; ++axis) a.wall_force[axis] += b.wall_force[axis];
      a.wall_power += b.wall_power;
      return a;
    };
    return reduce_blocks(store.range(Kind::fluid).size(), SweepOutcome{}, swept, combine);
  }

  void loads_on_walls(ParticleStore const& store, Search const& search,
                      std::vector<WallLoad>& loads) const override {
    add_up_wall_loads(pairs_, store, search, loads);
  }

  void loads_on_mirrors(ParticleStore const& store, Search const& search,
                        std::vector<MirrorLoad>& loads) const override {
    add_up_mirror_loads(pairs_, store, search, loads);
  }

  EnergyRates energy_rates(ParticleStore const& store, Search const& search) const override {
    auto const mass = store.scalar(Field::mass);
    auto const add = [&](std::size_t begin, std::size_t end) {
      EnergyRates rates;
      auto const use = [&](std::size_t i, auto const& sum, auto const& from_fluid) {
        double const all = sum_of_lanes(sum.energy_rate);
        double const inner = from_fluid ? sum_of_lanes(from_fluid->energy_rate) : all;
        rates.viscosity += mass[i] * inner;
        rates.wall_viscosity += mass[i] * (all - inner);
        rates.diffusion += mass[i] * pairs_.fluid.get(i, PairField::pressure_term) *
                           sum_of_lanes(sum.density_rate);
      };
      for_each_sum(search, begin, end, dissipative_terms<Number, D>(pairs_.parameters),
                   dissipative_wall_terms<Number>(pairs_.parameters), use);
      return rates;
    };
    auto const combine = [](EnergyRates const& a, EnergyRates const& b) {
      return EnergyRates{a.viscosity + b.viscosity, a.wall_viscosity + b.wall_viscosity,
                         a.diffusion + b.diffusion};
    };
    return reduce_blocks(pairs_.fluid.owned(), EnergyRates{}, add, combine);
  }

  std::uint64_t count_pairs(Search const& search) const override {
    auto const add = [](std::uint64_t a, std::uint64_t b) { return a + b; };
    auto const count = [&](std::size_t begin, std::size_t end) {
      std::uint64_t pairs = 0;
      for (std::size_t i = begin; i < end; ++i)
        pairs += count_near(i, search.fluid_fluid().points(i), pairs_.fluid) +
                 count_near(i, search.fluid_wall().points(i), pairs_.wall) +
                 (pairs_.parameters.mirror_walls
                      ? count_near(i, search.fluid_mirrored().points(i), pairs_.fluid)
                      : 0);
      return pairs;
    };
    return reduce_blocks(pairs_.fluid.owned(), std::uint64_t{0}, count, add);
  }

  std::size_t bytes() const override { return pairs_.fluid.bytes() + pairs_.wall.bytes(); }

 private:
  SweepOutcome sweep_block(ParticleStore& store, Search const& search, std::size_t begin,
                           std::size_t end) const {
    SweepOutcome outcome;
    SweepParameters const& p = pairs_.parameters;
    auto const density_rate = store.scalar(Field::density_rate);
    auto const energy_rate = store.scalar(Field::energy_rate);
    auto const sound_speed = store.scalar(Field::sound_speed);
    auto const particle_mass = store.scalar(Field::mass);
    std::span<double> acceleration[D];
    for (int axis = 0; axis < D; ++axis)
      acceleration[axis] = store.component(Field::acceleration, axis);
    auto const use = [&](std::size_t i, auto const& sum, auto const& from_fluid) {
      for (int axis = 0; axis < D; ++axis) {
        acceleration[axis][i] = sum_of_lanes(sum.acceleration[axis]);
        if (from_fluid)
          outcome.wall_force[static_cast<std::size_t>(axis)] +=
              particle_mass[i] *
              sum_of_lanes(sum.acceleration[axis] - from_fluid->acceleration[axis]);
      }
      if (from_fluid && p.walls_move)
        outcome.wall_power += particle_mass[i] * power_of_walls(i, sum, *from_fluid);
      density_rate[i] = sum_of_lanes(sum.density_rate);
      energy_rate[i] = sum_of_lanes(sum.energy_rate);
      double const mu = largest_lane(-sum.approach_speed);
      double const signal =
          sound_speed[i] +
          p.viscous_signal * (p.viscosity_alpha * sound_speed[i] + p.viscosity_beta * mu);
      if constexpr (Pairs::varies)
        outcome.include(signal * p.smoothing_length / pairs_.own_smoothing(i), i);
      else
        outcome.include(signal, i);
    };
    for_each_sum(search, begin, end, fluid_terms<Number, D>(p), wall_terms<Number>(p), use);
    return outcome;
  }

  /// What walls do to a particle, per mass [W/kg]: the work on its motion and on its inside. The
  /// sum over the pairs is the power of the force at the velocity of the wall.
  double power_of_walls(std::size_t i, PairSum<Number, D> const& all,
                        PairSum<Number, D> const& from_fluid) const {
    double power = sum_of_lanes(all.energy_rate - from_fluid.energy_rate);
    for (int axis = 0; axis < D; ++axis)
      power += sum_of_lanes(all.acceleration[axis] - from_fluid.acceleration[axis]) *
               pairs_.fluid.get(i, PairField::velocity, axis);
    return power;
  }

  /// Calls use(i, sum over all neighbours, the sum before wall neighbours were added if any were).
  template <class FluidTerms, class WallTerms, class Use>
  void for_each_sum(Search const& search, std::size_t begin, std::size_t end,
                    FluidTerms const& with_fluid, WallTerms const& with_wall, Use&& use) const {
    SweepConstants<Real, D, Kernel> const constants(pairs_.parameters);
    for (std::size_t i = begin; i < end; ++i) {
      Broadcast<Number, FluidLayout> const self{pairs_.fluid.record(i), pairs_.uniform.data()};
      PairSum<Number, D> sum{};
      if constexpr (Pairs::reference)
        reference_sum<false, D, Kernel, FluidLayout>(pairs_.parameters, self,
                                                     search.fluid_fluid().points(i),
                                                     pairs_.fluid.data(), with_fluid, sum);
      else
        sum_over_pairs<false, Real, D, Kernel, FluidLayout>(
            constants, self, search.fluid_fluid().of(i), pairs_.fluid.data(), with_fluid, sum);
      std::optional<PairSum<Number, D>> from_fluid;
      if (pairs_.parameters.mirror_walls && !search.fluid_mirrored().of(i).empty()) {
        from_fluid = sum;
        add_mirrored(constants, self, search, i, with_fluid, sum);
      }
      if (!search.fluid_wall().of(i).empty()) {
        if (!from_fluid) from_fluid = sum;
        if constexpr (Pairs::reference)
          reference_sum<true, D, Kernel, WallLayout>(pairs_.parameters, self,
                                                     search.fluid_wall().points(i),
                                                     pairs_.wall.data(), with_wall, sum);
        else
          sum_over_pairs<true, Real, D, Kernel, WallLayout>(
              constants, self, search.fluid_wall().of(i), pairs_.wall.data(), with_wall, sum);
      }
      use(i, sum, from_fluid);
    }
  }

  /// Adds the images of the fluid at walls. With `walls_keep_work` all of the work that their
  /// forces do stays in the particle,
  ///
  ///   de_i/dt = - v_i . dv_i/dt,
  ///
  /// as at other walls at rest; without, it is shared like that of any pair of the fluid.
  template <class Terms>
  void add_mirrored(SweepConstants<Real, D, Kernel> const& constants,
                    Broadcast<Number, FluidLayout> const& self, Search const& search, std::size_t i,
                    Terms const& terms, PairSum<Number, D>& sum) const {
    PairSum<Number, D> const before = sum;
    if constexpr (Pairs::reference)
      reference_sum<false, D, Kernel, FluidLayout>(pairs_.parameters, self,
                                                   search.fluid_mirrored().points(i),
                                                   pairs_.fluid.data(), terms, sum);
    else
      sum_over_pairs<false, Real, D, Kernel, FluidLayout>(
          constants, self, search.fluid_mirrored().of(i), pairs_.fluid.data(), terms, sum);
    if (!pairs_.parameters.walls_keep_work) return;
    sum.energy_rate = before.energy_rate;
    for (int axis = 0; axis < D; ++axis)
      sum.energy_rate -=
          (sum.acceleration[axis] - before.acceleration[axis]) * velocity(self, axis);
  }

  template <class Neighbours>
  std::uint64_t count_near(std::size_t i, std::span<std::uint32_t const> list,
                           Neighbours const& neighbours) const {
    std::uint64_t near = 0;
    for (std::uint32_t const j : list) {
      double h = pairs_.wall_smoothing(i);
      if constexpr (std::is_same_v<Neighbours, Records<typename Pairs::Slot, FluidLayout>>)
        h = pair_smoothing(pairs_.parameters.of_pair, pairs_.own_smoothing(i),
                           pairs_.own_smoothing(j));
      double const reach = kernel_support * h;
      double distance2 = 0.0;
      for (int axis = 0; axis < D; ++axis) {
        double const difference =
            metres_between(pairs_.fluid.record(i)[axis], neighbours.record(j)[axis],
                           pairs_.parameters.position_scale);
        distance2 += difference * difference;
      }
      near += distance2 < reach * reach ? 1 : 0;
    }
    return near;
  }

  Pairs pairs_;
  std::uint64_t rebuilds_seen_ = 0;
};

/// All schemes and kernels of one dimension and flavour. The reference looks for no speed: one
/// instance for all kernels does.
template <int D, Flavour flavour>
std::unique_ptr<PairBackend> make_backend(SchemeName scheme, SweepParameters const& p,
                                          std::vector<double> densities) {
  if (scheme == SchemeName::variable)
    return std::make_unique<PairBackendImpl<D, flavour, AnyKernel<D>, VariableScheme<D>>>(
        p, std::move(densities));
  auto const with = [&]<class Kernel>(Kernel) -> std::unique_ptr<PairBackend> {
    if constexpr (flavour != Flavour::reference) {
      if (scheme == SchemeName::liquid)
        return std::make_unique<PairBackendImpl<D, flavour, Kernel, LiquidScheme<D>>>(
            p, std::move(densities));
    }
    return std::make_unique<PairBackendImpl<D, flavour, Kernel, CompressibleScheme<D>>>(
        p, std::move(densities));
  };
  if constexpr (flavour != Flavour::reference) {
    if (p.kernel == KernelName::wendland_c2) return with(WendlandC2<D>{});
    if (p.kernel == KernelName::cubic_spline) return with(CubicSpline<D>{});
  }
  return with(AnyKernel<D>(p.kernel));
}

}  // namespace moraine
