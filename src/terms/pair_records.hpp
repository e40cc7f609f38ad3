// What all parts of a pair backend share: number types, parameters and the gathered records.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "search/neighbour_list.hpp"
#include "terms/pair_backend.hpp"
#include "terms/records.hpp"

namespace moraine {

/// Number type of the lanes. Short lists (1D, 2D) waste fewer lanes with half-width registers.
template <int D, Flavour flavour>
struct LaneType {
  static constexpr std::size_t floats = std::min(widest_float, NeighbourList::lanes(D));
  using Slot = std::conditional_t<flavour == Flavour::mixed, float, double>;
  using Real = std::conditional_t<flavour == Flavour::mixed, Simd<float, floats>,
                                  Simd<double, (widest_float / 2 < 4 ? 2 : widest_float / 2)>>;
};

/// The state of one backend between its passes.
template <int D, Flavour flavour, class KernelType, class SchemeType>
struct PairRecords {
  static constexpr int dimension = D;
  static constexpr bool reference = flavour == Flavour::reference;
  using Kernel = KernelType;
  using Scheme = SchemeType;
  using Slot = typename LaneType<D, flavour>::Slot;
  using Real = typename LaneType<D, flavour>::Real;
  using FluidLayout = typename Scheme::Fluid;
  using WallLayout = typename Scheme::Wall;
  using Number = std::conditional_t<reference, double, Real>;
  static constexpr bool varies = FluidLayout::has(PairField::smoothing_length);

  PairRecords(SweepParameters const& p, std::vector<double> densities)
      : parameters(p),
        uniform(p.template uniform_as<Slot>()),
        reference_densities(std::move(densities)),
        fluid(p.smoothing_length),
        wall(p.smoothing_length) {}

  /// h [m] of a fluid record.
  double own_smoothing([[maybe_unused]] std::size_t i) const {
    if constexpr (varies)
      return fluid.get(i, PairField::smoothing_length);
    else
      return parameters.smoothing_length;
  }

  /// h [m] of a fluid record against a wall.
  double wall_smoothing(std::size_t i) const {
    return std::max(own_smoothing(i), parameters.smoothing_length);
  }

  SweepParameters parameters;
  UniformFields<Slot> uniform;
  std::vector<double> reference_densities;  // kg/m^3, by material
  Records<Slot, FluidLayout> fluid;
  Records<Slot, WallLayout> wall;
};

}  // namespace moraine
