// The table of parameters outside materials, regions, walls and gauges; and the table as a whole.
#include <limits>
#include <utility>
#include <vector>

#include "setup/guard_table.hpp"
#include "setup/option_table.hpp"
#include "setup/parameter_table.hpp"

namespace moraine {
namespace {

constexpr auto numerics = &Case::numerics;
constexpr auto time_part = &Case::time;
constexpr auto output = &Case::output;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::string_view> kernel_names() {
  std::vector<std::string_view> names;
  for (KernelInfo const& kernel : kernel_table) names.push_back(kernel.name);
  return names;
}

// Told only where a side absorbs.
template <auto Member>
Entry<Case> absorbing_entry(Parameter parameter) {
  Entry<Case> entry = member<Case, &Case::absorbing, Member>(std::move(parameter));
  entry.get = [](Case const& c) {
    bool any = false;
    for (auto const& [low, high] : c.absorbing.sides) any = any || low || high;
    return any ? binding::load(c.absorbing.*Member) : Value();
  };
  return entry;
}

void add_space(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, &Case::title>(
      {.key = "title", .type = ValueType::text, .meaning = "one line that names the case"}));
  table.push_back(member<Case, &Case::dimension>(
      {.key = "space.dimension",
       .type = ValueType::integer,
       .presence = Presence::required,
       .limits = Limits::between(1.0, 3.0),
       .meaning = "number of dimensions; 2D and 1D are per metre of thickness"}));
  std::string_view const domain_note =
      "the box around walls and bounded regions, enlarged by its own extent on both "
      "sides of every axis that is not periodic";
  table.push_back(member<Case, &Case::domain, &Box::min>(
      {.key = "space.domain.min",
       .type = ValueType::vector,
       .quantity = Quantity::length,
       .presence = Presence::with_table,
       .preset_note = domain_note,
       .meaning = "lower corner of the domain; particles that leave it are counted and removed"}));
  table.push_back(
      member<Case, &Case::domain, &Box::max>({.key = "space.domain.max",
                                              .type = ValueType::vector,
                                              .quantity = Quantity::length,
                                              .presence = Presence::with_table,
                                              .preset_note = domain_note,
                                              .meaning = "upper corner of the domain"}));
  table.push_back(
      member<Case, &Case::periodic>({.key = "space.periodic",
                                     .type = ValueType::axes,
                                     .preset = std::vector<int>{},
                                     .meaning = "axes along which the domain repeats itself"}));
  table.push_back(member<Case, &Case::symmetry, &Symmetry::planes>(
      {.key = "space.symmetry",
       .type = ValueType::sides,
       .preset = std::vector<int>{},
       .meaning = "sides of the domain that are symmetry planes; sums and forces on walls are told "
                  "for the whole that they stand for"}));
  table.push_back(absorbing_entry<&AbsorbingSpec::sides>(
      {.key = "space.absorbing.sides",
       .type = ValueType::sides,
       .preset = std::vector<int>{},
       .meaning = "ends of the material, as it lies at the start, that absorb waves instead of "
                  "reflecting them"}));
  table.push_back(absorbing_entry<&AbsorbingSpec::thickness>(
      {.key = "space.absorbing.thickness",
       .quantity = Quantity::length,
       .presence = Presence::with_table,
       .preset_note = "none; needed where there are such sides",
       .limits = Limits::positive(),
       .meaning =
           "thickness of the absorbing layers, inwards from the ends; a third of the longest "
           "wave length or more"}));
  table.push_back(absorbing_entry<&AbsorbingSpec::reflection>(
      {.key = "space.absorbing.reflection",
       .preset = 1e-3,
       .limits = {.min = 1e-12, .max = 0.5},
       .meaning = "share of the amplitude of a wave straight on that comes back",
       .source = "Berenger, J. Comput. Phys. 114 (1994) 185"}));
  table.push_back(member<Case, &Case::gravity>(
      {.key = "physics.gravity",
       .type = ValueType::vector,
       .quantity = Quantity::acceleration,
       .preset = Point{},
       .meaning = "acceleration of every particle, constant in space and time"}));
}

void add_smoothing(std::vector<Entry<Case>>& table) {
  constexpr auto smoothing = &Numerics::smoothing;
  table.push_back(member<Case, numerics, smoothing, &Smoothing::mode>(
      {.key = "resolution.smoothing.mode",
       .type = ValueType::choice,
       .preset = static_cast<int>(SmoothingMode::constant),
       .names = {"constant", "rate", "density"},
       .meaning = "how the smoothing length of a particle follows its density: not at all, by the "
                  "rate of density, or as smoothing_factor (mass / density)^(1/dimension)",
       .source = "Benz (1990); Price, J. Comput. Phys. 231 (2012) 759, eq. 10"}));
  table.push_back(member<Case, numerics, smoothing, &Smoothing::of_pair>(
      {.key = "resolution.smoothing.of_pair",
       .type = ValueType::choice,
       .preset = static_cast<int>(PairSmoothing::arithmetic),
       .names = {"arithmetic", "geometric", "largest", "smallest"},
       .meaning = "mean of two smoothing lengths that a pair has, where they vary",
       .source = "Liu and Liu (2003), section 4.4"}));
  table.push_back(member<Case, numerics, smoothing, &Smoothing::rate_share>(
      {.key = "resolution.smoothing.rate_share",
       .preset = 1.0,
       .limits = Limits::between(0.0, 1.0),
       .meaning = "share of the rate of density that the smoothing length follows, with mode = "
                  "\"rate\"",
       .source = "1 keeps the number of neighbours; Benz (1990)"}));
  table.push_back(member<Case, numerics, smoothing, &Smoothing::least>(
      {.key = "resolution.smoothing.least",
       .preset = 0.5,
       .limits = Limits::between(0.1, 1.0),
       .meaning = "lower bound of a smoothing length that varies, divided by smoothing_factor "
                  "spacing"}));
  table.push_back(member<Case, numerics, smoothing, &Smoothing::most>(
      {.key = "resolution.smoothing.most",
       .preset = 2.0,
       .limits = Limits::between(1.0, 8.0),
       .meaning = "upper bound, likewise; walls are as thick as the support at this bound"}));
}

void add_resolution(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, numerics, &Numerics::spacing>(
      {.key = "resolution.spacing",
       .quantity = Quantity::length,
       .presence = Presence::required,
       .limits = Limits::positive(),
       .meaning = "distance of neighbouring particles on the initial lattice; their volume is "
                  "spacing^dimension"}));
  table.push_back(member<Case, &Case::lattice>(
      {.key = "resolution.lattice",
       .type = ValueType::choice,
       .preset = static_cast<int>(LatticeName::square),
       .names = {"square", "hexagonal"},
       .meaning = "arrangement of the particles at the start; in 3D cubic or face-centred cubic; a "
                  "particle has the volume spacing^dimension in all of them"}));
  table.push_back(member<Case, numerics, &Numerics::smoothing_factor>(
      {.key = "resolution.smoothing_factor",
       .preset = 1.2,
       .limits = Limits::between(0.8, 8.0),
       .meaning = "smoothing length divided by the spacing",
       .source = "1.0 to 1.2 is usual for blast; Liu and Liu (2003)"}));
  table.push_back(member<Case, numerics, &Numerics::kernel>(
      {.key = "resolution.kernel",
       .type = ValueType::choice,
       .preset = static_cast<int>(KernelName::wendland_c2),
       .names = kernel_names(),
       .meaning = "kernel function; the support of all is 2 smoothing lengths",
       .source = "Wendland, Adv. Comput. Math. 4 (1995) 389"}));
  add_smoothing(table);
}

void add_numerics(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, numerics, &Numerics::precision>(
      {.key = "numerics.precision",
       .type = ValueType::choice,
       .preset = static_cast<int>(Precision::mixed),
       .names = {"mixed", "double"},
       .meaning = "arithmetic of the pair sums; the state is double in both"}));
  table.push_back(member<Case, numerics, &Numerics::continuity>(
      {.key = "numerics.continuity",
       .type = ValueType::choice,
       .preset = static_cast<int>(ContinuityForm::mass),
       .names = {"mass", "volume"},
       .meaning = "weights of the continuity equation; volume where densities of neighbours differ "
                  "severalfold",
       .source = "Monaghan, Rep. Prog. Phys. 68 (2005) 1703, eqs 2.16 and 2.17"}));
  table.push_back(member<Case, numerics, &Numerics::momentum>(
      {.key = "numerics.momentum",
       .type = ValueType::choice,
       .preset = static_cast<int>(MomentumForm::conservative),
       .names = {"conservative", "mixed"},
       .meaning = "form of the pressure force and its energy; mixed belongs to continuity = "
                  "\"volume\", conservative to \"mass\"",
       .source = "Liu and Liu (2003), section 4.3"}));
  table.push_back(member<Case, numerics, &Numerics::density_diffusion>(
      {.key = "numerics.density_diffusion",
       .preset = 0.0,
       .limits = Limits::not_negative(),
       .meaning = "coefficient of the density diffusion term; 0: none"}));
  table.push_back(member<Case, numerics, &Numerics::viscosity_alpha>(
      {.key = "numerics.viscosity_alpha",
       .preset = 1.0,
       .limits = Limits::not_negative(),
       .meaning = "linear coefficient of the artificial viscosity",
       .source = "usual for blast"}));
  table.push_back(member<Case, numerics, &Numerics::viscosity_beta>(
      {.key = "numerics.viscosity_beta",
       .preset = 10.0,
       .limits = Limits::not_negative(),
       .meaning = "quadratic coefficient of the artificial viscosity",
       .source = "usual for blast"}));
}

// Both keys are shown only where there is another run.
void add_start(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, &Case::start, &StartSpec::run>(
      {.key = "start.run",
       .type = ValueType::text,
       .presence = Presence::with_table,
       .preset_note = "particles of regions only",
       .meaning = "folder of another run, from whose newest checkpoint the case takes its "
                  "particles; its path counts from the case file"}));
  Entry<Case> velocities = member<Case, &Case::start, &StartSpec::velocities>(
      {.key = "start.velocities",
       .type = ValueType::choice,
       .preset = static_cast<int>(StartVelocities::keep),
       .names = {"keep", "zero"},
       .meaning = "whether these particles keep their velocities or start at rest"});
  velocities.get = [](Case const& c) {
    return c.start.run.empty() ? Value() : binding::load(c.start.velocities);
  };
  table.push_back(velocities);
}

void add_time(std::vector<Entry<Case>>& table) {
  table.push_back(member<Case, time_part, &TimeSpec::end>({.key = "time.end",
                                                           .quantity = Quantity::time,
                                                           .presence = Presence::required,
                                                           .limits = Limits::positive(),
                                                           .meaning = "end of the simulation"}));
  table.push_back(member<Case, time_part, &TimeSpec::courant>(
      {.key = "time.courant",
       .preset = 0.3,
       .limits = {.min = 0.0, .max = 1.0, .min_excluded = true},
       .meaning = "factor of h / signal speed and of sqrt(h / acceleration) in the time step"}));
  table.push_back(member<Case, time_part, &TimeSpec::max_step>(
      {.key = "time.max_step",
       .quantity = Quantity::time,
       .preset = infinity,
       .limits = {.min = 0.0, .min_excluded = true, .infinity_allowed = true},
       .meaning = "upper bound of the time step"}));
  table.push_back(member<Case, time_part, &TimeSpec::fixed_step>(
      {.key = "time.fixed_step",
       .quantity = Quantity::time,
       .preset = 0.0,
       .limits = Limits::not_negative(),
       .meaning = "constant time step; 0: chosen anew in every step"}));
}

void add_output(std::vector<Entry<Case>>& table) {
  auto const interval = [](std::string_view key, std::string_view meaning) {
    return Parameter{.key = key,
                     .quantity = Quantity::time,
                     .preset = 0.0,
                     .limits = Limits::not_negative(),
                     .meaning = meaning};
  };
  table.push_back(member<Case, output, &OutputSpec::frame_interval>(
      interval("output.frames", "interval between frames; 0: only the first and the last")));
  table.push_back(
      member<Case, output, &OutputSpec::frame_times>({.key = "output.frame_times",
                                                      .type = ValueType::reals,
                                                      .quantity = Quantity::time,
                                                      .preset = std::vector<double>{},
                                                      .limits = Limits::not_negative(),
                                                      .meaning = "times of additional frames"}));
  table.push_back(member<Case, output, &OutputSpec::gauge_interval>(
      interval("output.gauges", "interval between gauge readings; 0: every step")));
  table.push_back(member<Case, output, &OutputSpec::sums_interval>(
      interval("output.sums", "interval between conserved sums; 0: every step")));
  table.push_back(member<Case, output, &OutputSpec::checkpoint_interval>(
      {.key = "output.checkpoints",
       .quantity = Quantity::time,
       .preset = 600.0,
       .limits = Limits::not_negative(),
       .meaning = "wall time between checkpoints; 0: only at the start and when it is stopped"}));
  table.push_back(member<Case, output, &OutputSpec::arrival_pressure>(
      {.key = "output.arrival_pressure",
       .quantity = Quantity::pressure,
       .preset_note = "no arrivals, no envelopes",
       .limits = Limits::positive(),
       .meaning = "rise of the pressure that counts as arrival; where given, frames hold the peak, "
                  "its time, the arrival and the impulse of each particle"}));
}

std::vector<Entry<Case>> make_table() {
  std::vector<Entry<Case>> table;
  add_space(table);
  add_resolution(table);
  add_numerics(table);
  add_options(table);
  add_start(table);
  add_time(table);
  add_output(table);
  add_guards(table);
  return table;
}

}  // namespace

std::span<Entry<Case> const> case_entries() {
  static std::vector<Entry<Case>> const table = make_table();
  return table;
}

std::vector<Parameter const*> all_parameters() {
  std::vector<Parameter const*> all;
  auto const append = [&all](auto const& entries) {
    for (auto const& entry : entries) all.push_back(&entry.parameter);
  };
  append(case_entries());
  append(material_entries());
  append(region_entries());
  append(wall_entries());
  append(gauge_entries());
  append(stage_entries());
  append(reference_entries());
  return all;
}

}  // namespace moraine
