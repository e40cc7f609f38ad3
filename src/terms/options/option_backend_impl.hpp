// The backend of the optional terms as a template; instantiated in option_backends_*.cpp only.
#pragma once

#include <algorithm>
#include <cmath>

#include "terms/options/moments.hpp"
#include "terms/options/option_loads.hpp"
#include "terms/options/option_neighbours.hpp"
#include "terms/options/option_terms.hpp"

namespace moraine {

template <int D, Flavour flavour, class Scheme>
class OptionBackendImpl final : public OptionBackend {
  using Real = typename LaneType<D, flavour>::Real;
  using FluidLayout = typename Scheme::Fluid;
  using Sum = OptionSum<Real, D>;
  static constexpr bool has_gradients = FluidLayout::has(PairField::correction);
  static constexpr auto sides = static_cast<std::size_t>(D);
  /// What comes of the moments of a particle: gradient of density, then correction.
  using Gradients = std::array<double, sides + symmetric_size<D>>;

 public:
  OptionBackendImpl(SweepParameters const& sweep, OptionParameters const& options,
                    OptionMatter matter)
      : options_(options),
        largest_viscosity_(largest_of(matter.dynamic_viscosity)),
        around_(sweep, std::move(matter)) {}

  void sum_densities(ParticleStore& store, Search const& search, WallData const& walls,
                     bool normalised) override {
    gather(store, search, walls, 0.0);
    auto const sums = [&](std::size_t i) {
      DensitySum<Real> sum{};
      around_.add_all(search, i, std::tuple{SummedDensity{}}, sum);
      return sum;
    };
    auto density = store.scalar(Field::density);
    auto const mass = store.scalar(Field::mass);
    around_.for_each_particle([&](std::size_t i) {
      density[i] = sum_of_lanes(sums(i).density) + mass[i] * around_.central_kernel(i);
    });
    if (!normalised) return;
    around_.records.gather_fluid(store, search, 0.0);
    scratch_.resize(density.size());
    around_.for_each_particle([&](std::size_t i) {
      double const own = mass[i] / density[i] * around_.central_kernel(i);
      scratch_[i] = density[i] / (sum_of_lanes(sums(i).volume) + own);
    });
    around_.for_each_particle([&](std::size_t i) { density[i] = scratch_[i]; });
  }

  void gather(ParticleStore const& store, Search const& search, WallData const& walls,
              double ahead) override {
    around_.gather(store, search, walls, ahead);
  }

  OptionOutcome sweep(ParticleStore& store, Search const& search) override {
    if (options_.viscosity != ViscosityForm::off) around_.show_fluid_to_walls(search);
    clear_drift(store);
    if constexpr (has_gradients) {
      gradients_.resize(around_.records.fluid.owned());
      std::fill(gradients_.begin(), gradients_.end(), Gradients{});
      if (options_.gradient_diffusion > 0.0) find_density_gradients(search);
    }
    if (options_.corrected_gradient || options_.shifting > 0.0) look_around(store, search);
    if constexpr (has_gradients) put_gradients(search);
    return sum_terms(store, search);
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
    return around_.records.fluid.bytes() + around_.records.wall.bytes() +
           scratch_.capacity() * sizeof(double) + gradients_.capacity() * sizeof(Gradients);
  }

 private:
  auto loads() const {
    auto const terms = option_terms<double>(around_.sweep, options_);
    return OptionLoads<D, flavour, Scheme, OptionSum<double, D>, std::decay_t<decltype(terms)>>(
        around_.sweep, terms, around_.records);
  }

  static MomentSum<double, D> in_one(MomentSum<Real, D> const& lanes) {
    MomentSum<double, D> sum{};
    for (int k = 0; k < symmetric_size<D>; ++k) sum.matrix[k] = sum_of_lanes(lanes.matrix[k]);
    for (int a = 0; a < D; ++a) {
      sum.concentration[a] = sum_of_lanes(lanes.concentration[a]);
      sum.density_slope[a] = sum_of_lanes(lanes.density_slope[a]);
    }
    sum.fastest2 = largest_lane(lanes.fastest2);
    return sum;
  }
  static Symmetric<D> correction_of(MomentSum<double, D> const& sum) {
    Symmetric<D> matrix{};
    std::copy(std::begin(sum.matrix), std::end(sum.matrix), matrix.begin());
    return gradient_correction<D>(matrix);
  }

  void find_density_gradients(Search const& search) {
    std::tuple const terms{Moments<Real>{true}};
    around_.for_each_particle([&](std::size_t i) {
      MomentSum<Real, D> lanes{};
      around_.add_fluid(search, i, terms, lanes);
      around_.add_mirrored(search, i, terms, lanes);
      MomentSum<double, D> const sum = in_one(lanes);
      Symmetric<D> const k = correction_of(sum);
      auto const entry = [&k](int at) { return k[static_cast<std::size_t>(at)]; };
      for (int a = 0; a < D; ++a)
        gradients_[i][static_cast<std::size_t>(a)] =
            sum.density_slope[a] + row_times<D>(entry, sum.density_slope, a);
    });
  }

  void clear_drift(ParticleStore& store) const {
    if (!store.has(Field::drift)) return;
    for (int axis = 0; axis < D; ++axis) {
      auto drift = store.component(Field::drift, axis);
      std::fill(drift.begin(), drift.end(), 0.0);
    }
  }

  /// Correction of gradients and shifting, both from all that is around a particle.
  void look_around(ParticleStore& store, Search const& search) {
    std::tuple const terms{Moments<Real>{false}};
    around_.for_each_particle([&](std::size_t i) {
      MomentSum<Real, D> lanes{};
      around_.add_all(search, i, terms, lanes);
      MomentSum<double, D> const sum = in_one(lanes);
      if constexpr (has_gradients) {
        Symmetric<D> const k = correction_of(sum);
        if (options_.corrected_gradient) std::copy(k.begin(), k.end(), gradients_[i].begin() + D);
      }
      if (!(options_.shifting > 0.0)) return;
      auto const shift = shifting_velocity<D>(options_.shifting, around_.own_smoothing(i), sum);
      for (int axis = 0; axis < D; ++axis)
        store.component(Field::drift, axis)[i] = shift[static_cast<std::size_t>(axis)];
    });
  }

  /// Records are filled only when nobody reads them any more.
  void put_gradients(Search const& search) {
    around_.for_each_particle([&](std::size_t i) {
      for (int a = 0; a < D; ++a)
        around_.records.fluid.set(i, PairField::density_gradient,
                                  gradients_[i][static_cast<std::size_t>(a)], a);
      for (int k = 0; k < symmetric_size<D>; ++k)
        around_.records.fluid.set(i, PairField::correction,
                                  gradients_[i][static_cast<std::size_t>(D + k)], k);
    });
    refresh_images(around_.records.fluid, search, around_.sweep);
  }

  OptionOutcome sum_terms(ParticleStore& store, Search const& search) const {
    auto const terms = option_terms<Real>(around_.sweep, options_);
    auto const block = [&](std::size_t begin, std::size_t end) {
      OptionOutcome outcome;
      for (std::size_t i = begin; i < end; ++i) {
        Sum sum{};
        around_.add_fluid(search, i, terms, sum);
        Sum const from_fluid = sum;
        around_.add_walls(search, i, terms, sum);
        add_to_store(store, i, sum);
        tell(store, i, sum, from_fluid, outcome);
      }
      return outcome;
    };
    auto const combine = [](OptionOutcome a, OptionOutcome const& b) {
      a.add(b);
      return a;
    };
    return reduce_blocks(around_.records.fluid.owned(), OptionOutcome{}, block, combine);
  }

  void add_to_store(ParticleStore& store, std::size_t i, Sum const& sum) const {
    double const mass = store.scalar(Field::mass)[i];
    for (int axis = 0; axis < D; ++axis)
      store.component(Field::acceleration, axis)[i] +=
          sum_of_lanes(sum.acceleration[axis]) + sum_of_lanes(sum.penalty_force[axis]) / mass;
    store.scalar(Field::density_rate)[i] +=
        sum_of_lanes(sum.density_rate) + sum_of_lanes(sum.diffusion);
    store.scalar(Field::energy_rate)[i] += sum_of_lanes(sum.energy_rate);
    if (!(options_.xsph > 0.0)) return;
    for (int axis = 0; axis < D; ++axis)
      store.component(Field::drift, axis)[i] += sum_of_lanes(sum.drift[axis]);
  }

  void tell(ParticleStore const& store, std::size_t i, Sum const& all, Sum const& from_fluid,
            OptionOutcome& outcome) const {
    double const mass = store.scalar(Field::mass)[i];
    double const rho = store.scalar(Field::density)[i];
    double const h = around_.own_smoothing(i);
    OptionOutcome own;
    own.viscous_rate = viscosity_felt_by(i) / (rho * h * h);
    own.viscous_particle = i;
    own.penalty_rate = sum_of_lanes(all.stiffness) / mass;
    own.penalty_particle = i;
    if (around_.sweep.walls_move)
      own.wall_power = mass * sum_of_lanes(all.energy_rate - from_fluid.energy_rate);
    for (int axis = 0; axis < D; ++axis) {
      double const from_walls =
          mass * sum_of_lanes(all.acceleration[axis] - from_fluid.acceleration[axis]);
      own.wall_force[static_cast<std::size_t>(axis)] = from_walls;
      if (around_.sweep.walls_move)
        own.wall_power += from_walls * around_.records.fluid.get(i, PairField::velocity, axis);
    }
    own.penalty_energy = sum_of_lanes(all.potential);
    own.energy.viscosity = mass * sum_of_lanes(from_fluid.viscous_heat);
    own.energy.wall_viscosity = mass * sum_of_lanes(all.viscous_heat - from_fluid.viscous_heat);
    own.energy.diffusion =
        mass * store.scalar(Field::pressure)[i] / (rho * rho) * sum_of_lanes(all.diffusion);
    outcome.add(own);
  }

  /// mu [Pa s] that limits the step of a particle: in Morris' form that of its neighbours drags it
  /// too, and none has more than the stiffest liquid. The harmonic mean of the other form is at
  /// most twice the particle's own.
  double viscosity_felt_by(std::size_t i) const {
    if (options_.viscosity == ViscosityForm::off) return 0.0;
    double const own = around_.records.fluid.get(i, PairField::dynamic_viscosity);
    return options_.viscosity == ViscosityForm::morris ? 0.5 * (own + largest_viscosity_) : own;
  }

  static double largest_of(std::vector<double> const& values) {
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
  }

  OptionParameters options_;
  double largest_viscosity_;  // Pa s, of all materials
  OptionNeighbours<D, flavour, Scheme> around_;
  std::vector<double> scratch_;
  std::vector<Gradients> gradients_;
};

/// The backend of one dimension and flavour.
template <int D, Flavour flavour>
std::unique_ptr<OptionBackend> make_options(SweepParameters const& sweep,
                                            OptionParameters const& options, OptionMatter matter) {
  if (options.needs_gradients())
    return std::make_unique<OptionBackendImpl<D, flavour, GradientOptions<D>>>(sweep, options,
                                                                               std::move(matter));
  return std::make_unique<OptionBackendImpl<D, flavour, PlainOptions<D>>>(sweep, options,
                                                                          std::move(matter));
}

}  // namespace moraine
