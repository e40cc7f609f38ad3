// Instances of the pair backend in 1D.
#include "terms/pair_backend_impl.hpp"

namespace moraine {

template std::unique_ptr<PairBackend> make_backend<1, Flavour::mixed>(SchemeName,
                                                                      SweepParameters const&,
                                                                      std::vector<double>);
template std::unique_ptr<PairBackend> make_backend<1, Flavour::full>(SchemeName,
                                                                     SweepParameters const&,
                                                                     std::vector<double>);
template std::unique_ptr<PairBackend> make_backend<1, Flavour::reference>(SchemeName,
                                                                          SweepParameters const&,
                                                                          std::vector<double>);

}  // namespace moraine
