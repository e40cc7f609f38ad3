#include "terms/pair_backend.hpp"

namespace moraine {

template <int D, Flavour flavour>
std::unique_ptr<PairBackend> make_backend(KernelName kernel, SchemeName scheme,
                                          SweepParameters const& parameters,
                                          std::vector<double> densities);

std::unique_ptr<PairBackend> make_pair_backend(int dimension, Flavour flavour, KernelName kernel,
                                               SchemeName scheme, SweepParameters const& parameters,
                                               std::vector<double> densities) {
  auto const with = [&]<int D>(std::integral_constant<int, D>) {
    switch (flavour) {
      case Flavour::mixed:
        return make_backend<D, Flavour::mixed>(kernel, scheme, parameters, std::move(densities));
      case Flavour::full:
        return make_backend<D, Flavour::full>(kernel, scheme, parameters, std::move(densities));
      default:
        return make_backend<D, Flavour::reference>(kernel, scheme, parameters,
                                                   std::move(densities));
    }
  };
  if (dimension == 1) return with(std::integral_constant<int, 1>{});
  if (dimension == 2) return with(std::integral_constant<int, 2>{});
  return with(std::integral_constant<int, 3>{});
}

}  // namespace moraine
