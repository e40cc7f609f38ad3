// Instances of the backend of solids in 2D.
#include "terms/strength/strength_backend_impl.hpp"

namespace moraine {

template std::unique_ptr<StrengthBackend> make_strength<2, Flavour::mixed>(SweepParameters const&,
                                                                           StrengthMatter);
template std::unique_ptr<StrengthBackend> make_strength<2, Flavour::full>(SweepParameters const&,
                                                                          StrengthMatter);

}  // namespace moraine
