// The pair backend as a template; instantiated from the list in pair_backends_*.cpp only.
#pragma once

#include <algorithm>
#include <optional>

#include "terms/lane_type.hpp"
#include "terms/pair_backend.hpp"
#include "terms/records.hpp"
#include "terms/reference_sweep.hpp"
#include "terms/schemes.hpp"
#include "terms/sweep.hpp"
#include "terms/wall_extrapolation.hpp"

namespace moraine {

template <int D, Flavour flavour, class Kernel, class Scheme>
class PairBackendImpl final : public PairBackend {
  using Slot = typename LaneType<D, flavour>::Slot;
  using Real = typename LaneType<D, flavour>::Real;
  using FluidLayout = typename Scheme::Fluid;
  using WallLayout = typename Scheme::Wall;
  using Number = std::conditional_t<flavour == Flavour::reference, double, Real>;
  static constexpr bool varies = FluidLayout::has(PairField::smoothing_length);

 public:
  PairBackendImpl(SweepParameters const& parameters, std::vector<double> reference_densities)
      : parameters_(parameters),
        uniform_(parameters.template uniform_as<Slot>()),
        reference_densities_(std::move(reference_densities)),
        fluid_(parameters.smoothing_length),
        wall_(parameters.smoothing_length) {}

  void gather_fluid(ParticleStore const& store, Search const& search, double ahead) override {
    Range const range = store.range(Kind::fluid);
    auto const& images = search.images(Kind::fluid);
    fluid_.resize(range.size(), images.size());
    parameters_.position_scale = search.settings().fixed_point.scale;
    for_each_block(range.size(), loop_block, [&](std::size_t begin, std::size_t end) {
      gather_vectors(store, search.settings().fixed_point, ahead, begin, end);
      gather_scalars(store, ahead, begin, end);
    });
    fluid_.refresh(images, search.settings().sides);
  }

  void gather_walls(ParticleStore& store, Search const& search, WallData const& walls) override {
    Range const range = store.range(Kind::wall);
    auto const& images = search.images(Kind::wall);
    if (rebuilds_seen_ != search.rebuilds()) {
      rebuilds_seen_ = search.rebuilds();
      wall_.resize(range.size(), images.size());
      place_walls(store, search.settings().fixed_point, walls);
    }
    auto const& wet = search.wet_walls();
    for_each_block(wet.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) {
        std::size_t const i = wet[n];
        if (walls.move()) place_wall(store, search.settings().fixed_point, walls, i);
        extrapolate_to(store, search, walls, range.begin + i, i);
        set_wall_state(store, range.begin + i, i);
      }
    });
    wall_.refresh(images, search.settings().sides);
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
    auto const& wet = search.wet_walls();
    loads.resize(wet.size());
    for_each_block(wet.size(), NeighbourList::block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n) loads[n] = load_on(store, search, wet[n]);
    });
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
        rates.diffusion +=
            mass[i] * fluid_.get(i, PairField::pressure_term) * sum_of_lanes(sum.density_rate);
      };
      for_each_sum(search, begin, end, dissipative_terms<Number, D>(parameters_),
                   dissipative_wall_terms<Number>(parameters_), use);
      return rates;
    };
    auto const combine = [](EnergyRates const& a, EnergyRates const& b) {
      return EnergyRates{a.viscosity + b.viscosity, a.wall_viscosity + b.wall_viscosity,
                         a.diffusion + b.diffusion};
    };
    return reduce_blocks(fluid_.owned(), EnergyRates{}, add, combine);
  }

  std::uint64_t count_pairs(Search const& search) const override {
    auto const add = [](std::uint64_t a, std::uint64_t b) { return a + b; };
    auto const count = [&](std::size_t begin, std::size_t end) {
      std::uint64_t pairs = 0;
      for (std::size_t i = begin; i < end; ++i)
        pairs += count_near(i, search.fluid_fluid().points(i), fluid_) +
                 count_near(i, search.fluid_wall().points(i), wall_);
      return pairs;
    };
    return reduce_blocks(fluid_.owned(), std::uint64_t{0}, count, add);
  }

  std::size_t bytes() const override { return fluid_.bytes() + wall_.bytes(); }

 private:
  void gather_vectors(ParticleStore const& store, FixedPoint const& map, double ahead,
                      std::size_t begin, std::size_t end) {
    for (int axis = 0; axis < D; ++axis) {
      auto const x = store.component(Field::position, axis);
      auto const v = store.component(Field::velocity, axis);
      auto const a = store.component(Field::acceleration, axis);
      for (std::size_t i = begin; i < end; ++i) {
        fluid_.set_position(i, axis, x[i], map);
        fluid_.set(i, PairField::velocity, v[i] + ahead * a[i], axis);
      }
    }
  }

  void gather_scalars(ParticleStore const& store, double ahead, std::size_t begin,
                      std::size_t end) {
    auto const density = store.scalar(Field::density);
    auto const density_rate = store.scalar(Field::density_rate);
    auto const pressure = store.scalar(Field::pressure);
    auto const material = store.material();
    double const to_now = parameters_.summed_density ? 0.0 : ahead;
    for (std::size_t i = begin; i < end; ++i) {
      double const rho = density[i] + to_now * density_rate[i];
      double const rho_0 = reference_densities_[material[i]];
      fluid_.set(i, PairField::pressure_term, pressure[i] / (rho * rho));
      fluid_.set(i, PairField::compression, (rho - rho_0) / rho_0);
      if constexpr (!Scheme::uniform) {
        fluid_.set(i, PairField::reference_density, rho_0);
        fluid_.set(i, PairField::mass, store.scalar(Field::mass)[i]);
        fluid_.set(i, PairField::sound_speed, store.scalar(Field::sound_speed)[i]);
      }
      if constexpr (varies)
        fluid_.set(i, PairField::smoothing_length, store.scalar(Field::smoothing_length)[i]);
    }
  }

  void extrapolate_to(ParticleStore& store, Search const& search, WallData const& walls,
                      std::size_t k, std::size_t i) {
    std::array<double, 3> gravity = parameters_.gravity;
    if (walls.move()) {
      WallPoint const& point = walls.points[store.id()[k] - walls.first_id];
      gravity = subtract(gravity, walls.acceleration(point, place_of(store, k)));
    }
    WallState const state =
        extrapolate<flavour == Flavour::reference, Real, D, Kernel, FluidLayout>(
            parameters_, wall_.record(i), uniform_.data(), search.wall_fluid(), i, fluid_.data(),
            gravity);
    if (state.weight <= 0.0) return;
    store.scalar(Field::pressure)[k] = state.pressure;
    store.scalar(Field::density)[k] = state.density;
    store.scalar(Field::sound_speed)[k] = state.sound_speed;
  }

  /// What stays the same between rebuilds of the lists where walls are at rest.
  void place_walls(ParticleStore const& store, FixedPoint const& map, WallData const& walls) {
    for_each_block(wall_.owned(), loop_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) place_wall(store, map, walls, i);
    });
  }

  void place_wall(ParticleStore const& store, FixedPoint const& map, WallData const& walls,
                  std::size_t i) {
    std::size_t const k = store.range(Kind::wall).begin + i;
    WallPoint const& point = walls.points[store.id()[k] - walls.first_id];
    Vec3 const place = place_of(store, k);
    Vec3 const velocity = walls.velocity(point, place);
    Vec3 const normal = walls.normal(point);
    [[maybe_unused]] Vec3 const turn = cross(normal, walls.angular_velocity(point));
    wall_.set(i, PairField::wall_depth, point.free_slip ? point.depth : -point.depth);
    for (int axis = 0; axis < D; ++axis) {
      auto const component = static_cast<std::size_t>(axis);
      wall_.set_position(i, axis, place[component], map);
      wall_.set(i, PairField::velocity, velocity[component], axis);
      wall_.set(i, PairField::normal, normal[component], axis);
      if constexpr (WallLayout::has(PairField::wall_turn))
        wall_.set(i, PairField::wall_turn, turn[component], axis);
    }
  }

  static Vec3 place_of(ParticleStore const& store, std::size_t k) {
    Vec3 place{};
    for (int axis = 0; axis < D; ++axis)
      place[static_cast<std::size_t>(axis)] = store.component(Field::position, axis)[k];
    return place;
  }

  void set_wall_state(ParticleStore const& store, std::size_t k, std::size_t i) {
    double const rho = store.scalar(Field::density)[k];
    double const p = store.scalar(Field::pressure)[k];
    wall_.set(i, PairField::pressure_term, p / (rho * rho));
    if constexpr (Scheme::uniform) {
      double const rho_0 =
          parameters_.uniform[static_cast<std::size_t>(PairField::reference_density)];
      wall_.set(i, PairField::compression, (rho - rho_0) / rho_0);
    } else {
      wall_.set(i, PairField::reference_density, rho);
      wall_.set(i, PairField::sound_speed, store.scalar(Field::sound_speed)[k]);
    }
  }

  SweepOutcome sweep_block(ParticleStore& store, Search const& search, std::size_t begin,
                           std::size_t end) const {
    SweepOutcome outcome;
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
      if (from_fluid && parameters_.walls_move)
        outcome.wall_power += particle_mass[i] * power_of_walls(i, sum, *from_fluid);
      density_rate[i] = sum_of_lanes(sum.density_rate);
      energy_rate[i] = sum_of_lanes(sum.energy_rate);
      double const mu = largest_lane(-sum.approach_speed);
      double const signal = sound_speed[i] + parameters_.viscous_signal *
                                                 (parameters_.viscosity_alpha * sound_speed[i] +
                                                  parameters_.viscosity_beta * mu);
      if constexpr (varies)
        outcome.include(signal * parameters_.smoothing_length / own_smoothing(i), i);
      else
        outcome.include(signal, i);
    };
    for_each_sum(search, begin, end, fluid_terms<Number, D>(parameters_),
                 wall_terms<Number>(parameters_), use);
    return outcome;
  }

  /// What walls do to a particle, per mass [W/kg]: the work on its motion and on its inside. The
  /// sum over the pairs is the power of the force at the velocity of the wall.
  double power_of_walls(std::size_t i, PairSum<Number, D> const& all,
                        PairSum<Number, D> const& from_fluid) const {
    double power = sum_of_lanes(all.energy_rate - from_fluid.energy_rate);
    for (int axis = 0; axis < D; ++axis)
      power += sum_of_lanes(all.acceleration[axis] - from_fluid.acceleration[axis]) *
               fluid_.get(i, PairField::velocity, axis);
    return power;
  }

  /// Calls use(i, sum over all neighbours, the sum before wall neighbours were added if any were).
  template <class FluidTerms, class WallTerms, class Use>
  void for_each_sum(Search const& search, std::size_t begin, std::size_t end,
                    FluidTerms const& with_fluid, WallTerms const& with_wall, Use&& use) const {
    SweepConstants<Real, D, Kernel> const constants(parameters_);
    for (std::size_t i = begin; i < end; ++i) {
      Broadcast<Number, FluidLayout> const self{fluid_.record(i), uniform_.data()};
      PairSum<Number, D> sum{};
      if constexpr (flavour == Flavour::reference)
        reference_sum<false, D, Kernel, FluidLayout>(
            parameters_, self, search.fluid_fluid().points(i), fluid_.data(), with_fluid, sum);
      else
        sum_over_pairs<false, Real, D, Kernel, FluidLayout>(
            constants, self, search.fluid_fluid().of(i), fluid_.data(), with_fluid, sum);
      std::optional<PairSum<Number, D>> from_fluid;
      if (!search.fluid_wall().of(i).empty()) {
        from_fluid = sum;
        if constexpr (flavour == Flavour::reference)
          reference_sum<true, D, Kernel, WallLayout>(
              parameters_, self, search.fluid_wall().points(i), wall_.data(), with_wall, sum);
        else
          sum_over_pairs<true, Real, D, Kernel, WallLayout>(
              constants, self, search.fluid_wall().of(i), wall_.data(), with_wall, sum);
      }
      use(i, sum, from_fluid);
    }
  }

  /// The force of all fluid particles on one wall particle: each pair as in the sweep, in double.
  WallLoad load_on(ParticleStore const& store, Search const& search, std::size_t w) const {
    auto const terms = wall_terms<double>(parameters_);
    auto const uniform = parameters_.template uniform_as<double>();
    auto const wall = wall_.in_metres(w, parameters_.position_scale);
    static constexpr std::array<std::uint32_t, 1> only{0};
    auto const& images = search.images(Kind::fluid);
    WallLoad load;
    for (std::uint32_t const j : search.wall_fluid().points(w)) {
      auto const fluid = fluid_.in_metres(j, parameters_.position_scale);
      double distance2 = 0.0;
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis)
        distance2 += (fluid[axis] - wall[axis]) * (fluid[axis] - wall[axis]);
      double const reach = kernel_support * wall_smoothing(j);
      if (distance2 >= reach * reach) continue;
      load.wet = true;
      Broadcast<double, FluidLayout> const self{fluid.data(), uniform.data()};
      PairSum<double, D> sum{};
      reference_sum<true, D, Kernel, WallLayout>(parameters_, self, only, wall.data(), terms, sum);
      std::size_t const owner = j < fluid_.owned() ? j : images[j - fluid_.owned()].source;
      double const mass = store.scalar(Field::mass)[owner];
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(D); ++axis)
        load.force[axis] -= mass * sum.acceleration[axis];
    }
    return load;
  }

  template <class Neighbours>
  std::uint64_t count_near(std::size_t i, std::span<std::uint32_t const> list,
                           Neighbours const& neighbours) const {
    std::uint64_t near = 0;
    for (std::uint32_t const j : list) {
      double h = wall_smoothing(i);
      if constexpr (std::is_same_v<Neighbours, Records<Slot, FluidLayout>>)
        h = pair_smoothing(parameters_.of_pair, own_smoothing(i), own_smoothing(j));
      double const reach = kernel_support * h;
      double distance2 = 0.0;
      for (int axis = 0; axis < D; ++axis) {
        double const difference =
            metres_between(fluid_.record(i)[axis], neighbours.record(j)[axis]);
        distance2 += difference * difference;
      }
      near += distance2 < reach * reach ? 1 : 0;
    }
    return near;
  }

  /// h [m] of a fluid record.
  double own_smoothing([[maybe_unused]] std::size_t i) const {
    if constexpr (varies)
      return fluid_.get(i, PairField::smoothing_length);
    else
      return parameters_.smoothing_length;
  }

  /// h [m] of a fluid record against a wall.
  double wall_smoothing(std::size_t i) const {
    return std::max(own_smoothing(i), parameters_.smoothing_length);
  }

  double metres_between(Slot a, Slot b) const {
    if constexpr (std::is_same_v<Slot, float>)
      return (static_cast<double>(std::bit_cast<Units>(a)) -
              static_cast<double>(std::bit_cast<Units>(b))) *
             parameters_.position_scale;
    else
      return a - b;
  }

  SweepParameters parameters_;
  UniformFields<Slot> uniform_;
  std::vector<double> reference_densities_;
  Records<Slot, FluidLayout> fluid_;
  Records<Slot, WallLayout> wall_;
  std::uint64_t rebuilds_seen_ = 0;
};

/// All schemes and kernels of one dimension and flavour.
template <int D, Flavour flavour>
std::unique_ptr<PairBackend> make_backend(SchemeName scheme, SweepParameters const& p,
                                          std::vector<double> densities) {
  if (scheme == SchemeName::variable)
    return std::make_unique<PairBackendImpl<D, flavour, AnyKernel<D>, VariableScheme<D>>>(
        p, std::move(densities));
  auto const with = [&]<class Kernel>(Kernel) -> std::unique_ptr<PairBackend> {
    if (scheme == SchemeName::liquid && flavour != Flavour::reference) {
      using Liquid = PairBackendImpl<D, flavour == Flavour::reference ? Flavour::full : flavour,
                                     Kernel, LiquidScheme<D>>;
      return std::make_unique<Liquid>(p, std::move(densities));
    }
    return std::make_unique<PairBackendImpl<D, flavour, Kernel, CompressibleScheme<D>>>(
        p, std::move(densities));
  };
  if (p.kernel == KernelName::wendland_c2) return with(WendlandC2<D>{});
  if (p.kernel == KernelName::cubic_spline) return with(CubicSpline<D>{});
  return with(AnyKernel<D>(p.kernel));
}

}  // namespace moraine
