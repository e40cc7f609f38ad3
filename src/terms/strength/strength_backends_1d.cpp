// Instances of the backend of solids in 1D.
#include "terms/strength/strength_backend_impl.hpp"

namespace moraine {

template std::unique_ptr<StrengthBackend> make_strength<1, Flavour::mixed>(SweepParameters const&,
                                                                           StrengthMatter);
template std::unique_ptr<StrengthBackend> make_strength<1, Flavour::full>(SweepParameters const&,
                                                                          StrengthMatter);

}  // namespace moraine
