#include "terms/pair_backend.hpp"

namespace moraine {

template <int D, Flavour flavour>
std::unique_ptr<PairBackend> make_backend(SchemeName scheme, SweepParameters const& parameters,
                                          std::vector<double> densities);

std::unique_ptr<PairBackend> make_pair_backend(int dimension, Flavour flavour, SchemeName scheme,
                                               SweepParameters const& parameters,
                                               std::vector<double> densities) {
  auto const with = [&]<int D>(std::integral_constant<int, D>) {
    switch (flavour) {
      case Flavour::mixed:
        return make_backend<D, Flavour::mixed>(scheme, parameters, std::move(densities));
      case Flavour::full:
        return make_backend<D, Flavour::full>(scheme, parameters, std::move(densities));
      default:
        return make_backend<D, Flavour::reference>(scheme, parameters, std::move(densities));
    }
  };
  if (dimension == 1) return with(std::integral_constant<int, 1>{});
  if (dimension == 2) return with(std::integral_constant<int, 2>{});
  return with(std::integral_constant<int, 3>{});
}

}  // namespace moraine
