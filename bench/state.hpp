// A state of particles with everything that the pair loops need, outside of any simulation.
#pragma once

#include <benchmark/benchmark.h>
#include <omp.h>

#include <memory>

#include "bench/workload.hpp"
#include "setup/build_model.hpp"
#include "step/simulation_setup.hpp"

namespace moraine::parts {

/// All parts run on one thread: Google Benchmark counts the processor time of the caller alone.
inline bool const one_thread = (omp_set_num_threads(1), true);

struct State {
  State(Model from, Flavour flavour, SchemeName scheme)
      : model(std::move(from)),
        search(search_settings(model)),
        pairs(make_pair_backend(model.dimension, flavour, scheme, sweep_parameters(model),
                                reference_densities(model))) {
    search.refresh(model.particles);
    pairs->gather_fluid(model.particles, search, 0.0);
    pairs->gather_walls(model.particles, search, model.walls);
  }
  std::size_t fluid() const { return model.particles.range(Kind::fluid).size(); }

  Model model;
  Search search;
  std::unique_ptr<PairBackend> pairs;
};

/// A dam break of 9 900 particles in 3D, 11 988 in 2D.
inline State dam_break_state(int dimension, Flavour flavour = Flavour::mixed,
                             SchemeName scheme = SchemeName::liquid) {
  return {build_model(dam_break(dimension, dimension == 3 ? 0.02 : 1.0 / 316.0, Precision::mixed)),
          flavour, scheme};
}

/// Entries of all lists, padding included.
inline double listed(NeighbourList const& lists) {
  std::size_t groups = 0;
  for (std::size_t i = 0; i < lists.size(); ++i) groups += lists.of(i).count;
  return static_cast<double>(groups * lists.lanes());
}

/// Things done per second, as Google Benchmark prints them.
inline benchmark::Counter per_second(double things_per_iteration) {
  return {things_per_iteration, benchmark::Counter::kIsIterationInvariantRate};
}

}  // namespace moraine::parts
