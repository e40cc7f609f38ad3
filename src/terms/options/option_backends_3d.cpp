// Instances of the backend of optional terms in 3D.
#include "terms/options/option_backend_impl.hpp"

namespace moraine {

template std::unique_ptr<OptionBackend> make_options<3, Flavour::mixed>(SweepParameters const&,
                                                                        OptionParameters const&,
                                                                        OptionMatter);
template std::unique_ptr<OptionBackend> make_options<3, Flavour::full>(SweepParameters const&,
                                                                       OptionParameters const&,
                                                                       OptionMatter);

}  // namespace moraine
