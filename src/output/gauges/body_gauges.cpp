// Gauges of kind crater, deposit, bubble and rise.
#include <cmath>
#include <limits>
#include <memory>

#include "output/gauges/gauge_columns.hpp"
#include "output/gauges/makers.hpp"
#include "probes/body_probes.hpp"
#include "probes/connected_body.hpp"
#include "probes/crater_probe.hpp"

namespace moraine {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ConnectedBody bulk_of(Simulation const& simulation, Selection const& selection) {
  ParticleStore const& store = simulation.particles();
  return connected_body(store, simulation.search(), simulation.model().numerics.smoothing_length(),
                        selection.of(store));
}

BodyView view_of(Simulation const& simulation, ConnectedBody const& body, Upwards const& up) {
  Numerics const& numerics = simulation.model().numerics;
  return {simulation.particles(),      simulation.search(), numerics.kernel,
          numerics.smoothing_length(), body.members,        up};
}

CraterPlace crater_place(Case const& c, CraterSpec const& spec) {
  return {spec.level,        spec.center,  spec.radius.value_or(infinity),
          spec.sectors,      c.domain.min, c.domain.max,
          c.numerics.spacing};
}

}  // namespace

GaugeReader crater_reader(Case const& c, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  GaugeReader reader{name,
                     {{name + " apparent_diameter", "m"},
                      {name + " rim_diameter", "m"},
                      {name + " depth", "m"},
                      {name + " volume", unit_of_length(c.dimension)},
                      {name + " rim_height", "m"},
                      {name + " detached_share", ""}},
                     {}};
  reader.read = [selection = selection_of(c, gauge), up = up_of(c, gauge),
                 place = crater_place(c, gauge.probe.crater)](ReadingContext const& at,
                                                              std::vector<double>& row) {
    ConnectedBody const body = bulk_of(at.simulation, selection);
    CraterReading const crater = probe_crater(view_of(at.simulation, body, up), place);
    row.insert(row.end(), {crater.apparent_diameter, crater.rim_diameter, crater.depth,
                           crater.volume, crater.rim_height, body.detached_share()});
    return crater.depth > 0.0;
  };
  return reader;
}

GaugeReader deposit_reader(Case const& c, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  DepositSpec const& spec = gauge.probe.deposit;
  DepositFrame frame{up_of(c, gauge), spec.base, spec.origin.value_or(Vec3{}), std::nullopt};
  if (spec.along)
    frame.along =
        Upwards{static_cast<std::size_t>(*spec.along / 2), *spec.along % 2 == 1 ? 1.0 : -1.0};
  auto const read = [selection = selection_of(c, gauge), frame](ReadingContext const& at,
                                                                std::vector<double>& row) {
    ConnectedBody const body = bulk_of(at.simulation, selection);
    DepositReading const deposit = probe_deposit(at.simulation.particles(), body.members, frame);
    row.insert(row.end(), {deposit.run_out, deposit.height, deposit.front_angle,
                           static_cast<double>(body.detached), body.detached_share()});
    return body.particles > 0;
  };
  return {name,
          {{name + " run_out", "m"},
           {name + " height", "m"},
           {name + " front_angle", "rad"},
           {name + " detached_particles", ""},
           {name + " detached_share", ""}},
          read};
}

GaugeReader bubble_reader(Case const& c, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  GaugeReader reader{
      name, {{name + " volume", unit_of_length(c.dimension)}, {name + " radius", "m"}}, {}};
  for (auto const* part : {" center", " low", " high"})
    add_vector_columns(reader.columns, name + part, c.dimension, "m");
  reader.read = [selection = selection_of(c, gauge)](ReadingContext const& at,
                                                     std::vector<double>& row) {
    Model const& model = at.simulation.model();
    BubbleReading const bubble =
        probe_bubble(at.simulation.particles(), selection, model.symmetry.copies());
    row.insert(row.end(), {bubble.volume, bubble.radius});
    for (Vec3 const* part : {&bubble.center, &bubble.low, &bubble.high})
      row.insert(row.end(), part->begin(), part->begin() + model.dimension);
    return bubble.volume > 0.0;
  };
  return reader;
}

GaugeReader rise_reader(Case const& c, GaugeSpec const& gauge) {
  std::string const& name = gauge.name;
  Selection selection = selection_of(c, gauge);
  PlaceBox const within = selection.within.value_or(PlaceBox{c.domain.min, c.domain.max});
  selection.within.reset();  // whether a piece is detached shows in the whole
  auto const start =
      std::make_shared<std::vector<double>>(1, std::numeric_limits<double>::quiet_NaN());
  GaugeReader reader{name, {{name + " highest", "m"}, {name + " rise", "m"}}, {}, start};
  reader.read = [selection, within, up = up_of(c, gauge), start](ReadingContext const& at,
                                                                 std::vector<double>& row) {
    ConnectedBody const body = bulk_of(at.simulation, selection);
    double const highest = probe_highest(view_of(at.simulation, body, up), within);
    double& first = start->front();
    if (std::isnan(first)) first = highest;
    row.insert(row.end(), {highest, highest - first});
    return !std::isnan(highest);
  };
  return reader;
}

}  // namespace moraine
