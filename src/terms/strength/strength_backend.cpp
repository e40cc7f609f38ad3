#include "terms/strength/strength_backend.hpp"

#include <type_traits>
#include <utility>

namespace moraine {

template <int D, Flavour flavour>
std::unique_ptr<StrengthBackend> make_strength(SweepParameters const& sweep, StrengthMatter matter);

std::unique_ptr<StrengthBackend> make_strength_backend(int dimension, Flavour flavour,
                                                       SweepParameters const& sweep,
                                                       StrengthMatter matter) {
  auto const with = [&]<int D>(std::integral_constant<int, D>) {
    return flavour == Flavour::mixed ? make_strength<D, Flavour::mixed>(sweep, std::move(matter))
                                     : make_strength<D, Flavour::full>(sweep, std::move(matter));
  };
  if (dimension == 1) return with(std::integral_constant<int, 1>{});
  if (dimension == 2) return with(std::integral_constant<int, 2>{});
  return with(std::integral_constant<int, 3>{});
}

}  // namespace moraine
