// The backend of solids as a template; instantiated in strength_backends_*.cpp only.
#pragma once

#include <algorithm>

#include "terms/options/option_loads.hpp"
#include "terms/options/option_neighbours.hpp"
#include "terms/strength/artificial_stress.hpp"
#include "terms/strength/strength_backend.hpp"
#include "terms/strength/strength_terms.hpp"

namespace moraine {

template <int D, Flavour flavour, class Scheme>
class StrengthBackendImpl final : public StrengthBackend {
  using Real = typename LaneType<D, flavour>::Real;
  using Sum = StrengthSum<Real, D>;

 public:
  StrengthBackendImpl(SweepParameters const& sweep, StrengthMatter matter)
      : solid_(std::move(matter.solid)),
        tension_(matter.artificial_stress),
        kernel_at_spacing_(kernel_at(sweep, 1.0 / matter.smoothing_factor)),
        around_(sweep, OptionMatter{std::move(matter.reference_density), {}, {}}) {}

  void gather(ParticleStore const& store, Search const& search, WallData const& walls,
              double ahead) override {
    around_.gather(store, search, walls, ahead);
    if constexpr (Scheme::Fluid::has(PairField::artificial_stress)) {
      put_artificial_stress(store);
      refresh_images(around_.records.fluid, search, around_.sweep);
    }
    find_solids(store, search);
  }

  StrengthOutcome sweep(ParticleStore& store, Search const& search) override {
    auto const terms = strength_terms<Real>(around_.sweep, kernel_at_spacing_);
    auto const block = [&](std::size_t begin, std::size_t end) {
      StrengthOutcome outcome;
      for (std::size_t i = begin; i < end; ++i) {
        if (!takes_part_[i]) continue;
        Sum sum{};
        around_.add_fluid(search, i, terms, sum);
        Sum const from_fluid = sum;
        around_.add_walls(search, i, terms, sum);
        add_to_store(store, i, sum);
        tell(store, i, sum, from_fluid, outcome);
      }
      return outcome;
    };
    auto const combine = [](StrengthOutcome a, StrengthOutcome const& b) {
      for (std::size_t axis = 0; axis < 3; ++axis) a.wall_force[axis] += b.wall_force[axis];
      a.wall_power += b.wall_power;
      return a;
    };
    return reduce_blocks(around_.records.fluid.owned(), StrengthOutcome{}, block, combine);
  }

  void add_loads_on_walls(ParticleStore const& store, Search const& search,
                          std::vector<WallLoad>& loads) const override {
    this->loads().add_on_walls(store, search, loads);
  }

  void add_loads_on_mirrors(ParticleStore const& store, Search const& search,
                            std::vector<MirrorLoad>& loads) const override {
    this->loads().add_on_mirrors(store, search, loads);
  }

  std::size_t bytes() const override {
    return around_.records.fluid.bytes() + around_.records.wall.bytes() + takes_part_.capacity();
  }

 private:
  auto loads() const {
    auto const terms = strength_terms<double>(around_.sweep, kernel_at_spacing_);
    return OptionLoads<D, flavour, Scheme, StrengthSum<double, D>, std::decay_t<decltype(terms)>>(
        around_.sweep, terms, around_.records);
  }

  /// W h^d at the distance q h.
  static double kernel_at(SweepParameters const& sweep, double q) {
    AnyKernel<D> const kernel(sweep.kernel);
    return kernel.sigma * kernel.shape(q);
  }

  void put_artificial_stress(ParticleStore const& store) {
    auto const pressure = store.scalar(Field::pressure);
    auto const mass = store.scalar(Field::mass);
    around_.for_each_particle([&](std::size_t i) {
      Symmetric<D> kept{};
      for (int k = 0; k < symmetric_size<D>; ++k)
        kept[static_cast<std::size_t>(k)] = store.component(Field::predicted_stress, k)[i];
      double const rho = mass[i] / around_.records.fluid.get(i, PairField::volume);
      bool const solid = solid_[store.material()[i]] != 0;
      Symmetric<3> const r =
          artificial_stress_of(unpacked<D>(kept), pressure[i], rho, solid ? tension_ : 0.0);
      Symmetric<D> const in_plane = packed<D>(r);
      for (int k = 0; k < symmetric_size<D>; ++k)
        around_.records.fluid.set(i, PairField::artificial_stress,
                                  in_plane[static_cast<std::size_t>(k)], k);
    });
  }

  /// Solids, and what has one in its lists: looked for when lists are made, and when a stage has
  /// made solids of fluids or fluids of solids.
  void find_solids(ParticleStore const& store, Search const& search) {
    std::size_t const owned = around_.records.fluid.owned();
    auto const solid = [&](std::size_t i) { return solid_[store.material()[i]] != 0; };
    std::uint64_t solids = 0;  // of which particles, not how many
    for (std::size_t i = 0; i < owned; ++i) solids += solid(i) ? store.id()[i] + 1 : 0;
    if (search.rebuilds() == rebuilds_seen_ && solids == solids_seen_ && !takes_part_.empty())
      return;
    rebuilds_seen_ = search.rebuilds();
    solids_seen_ = solids;
    takes_part_.resize(owned);
    auto const& images = search.images(Kind::fluid);
    around_.for_each_particle([&](std::size_t i) {
      bool part = solid(i);
      if (!part && solids > 0)
        for (std::uint32_t const j : search.fluid_fluid().points(i))
          part = part || solid(j < owned ? j : images[j - owned].source);
      takes_part_[i] = part ? 1 : 0;
    });
  }

  void add_to_store(ParticleStore& store, std::size_t i, Sum const& sum) const {
    for (int axis = 0; axis < D; ++axis)
      store.component(Field::acceleration, axis)[i] += sum_of_lanes(sum.acceleration[axis]);
    store.scalar(Field::energy_rate)[i] += sum_of_lanes(sum.energy_rate);
    for (int k = 0; k < D * D; ++k)
      store.component(Field::velocity_gradient, k)[i] = sum_of_lanes(sum.gradient[k]);
  }

  void tell(ParticleStore const& store, std::size_t i, Sum const& all, Sum const& from_fluid,
            StrengthOutcome& outcome) const {
    double const mass = store.scalar(Field::mass)[i];
    if (around_.sweep.walls_move)
      outcome.wall_power += mass * sum_of_lanes(all.energy_rate - from_fluid.energy_rate);
    for (int axis = 0; axis < D; ++axis) {
      double const force =
          mass * sum_of_lanes(all.acceleration[axis] - from_fluid.acceleration[axis]);
      outcome.wall_force[static_cast<std::size_t>(axis)] += force;
      if (around_.sweep.walls_move)
        outcome.wall_power += force * around_.records.fluid.get(i, PairField::velocity, axis);
    }
  }

  std::vector<std::uint8_t> solid_;  // by material
  double tension_;                   // epsilon of the artificial stress
  double kernel_at_spacing_;         // W h^d
  std::vector<std::uint8_t> takes_part_;
  std::uint64_t rebuilds_seen_ = 0;
  std::uint64_t solids_seen_ = 0;
  OptionNeighbours<D, flavour, Scheme> around_;
};

/// The backend of one dimension and flavour.
template <int D, Flavour flavour>
std::unique_ptr<StrengthBackend> make_strength(SweepParameters const& sweep,
                                               StrengthMatter matter) {
  if (matter.artificial_stress > 0.0)
    return std::make_unique<StrengthBackendImpl<D, flavour, TensionScheme<D>>>(sweep,
                                                                               std::move(matter));
  return std::make_unique<StrengthBackendImpl<D, flavour, StrengthScheme<D>>>(sweep,
                                                                              std::move(matter));
}

}  // namespace moraine
