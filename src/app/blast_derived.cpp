#include "app/blast_derived.hpp"

#include <fmt/core.h>

#include <cmath>

#include "blast/kingery_bulmash.hpp"
#include "blast/pulse.hpp"
#include "blast/sachs.hpp"

namespace moraine {

using blast::Kind;
using blast::Situation;
using blast::Topic;

bool from_charge(BlastReader const& reader, TopicCommand const& command) {
  bool const may = command.topic == Topic::reflection || command.topic == Topic::pulse;
  return may && !reader.given("--pressure") &&
         (reader.given("--charge") || reader.given("--distance"));
}

void refuse_two_fronts(BlastReader& reader, TopicCommand const& command,
                       BlastOptions const& options) {
  if (command.topic != Topic::reflection && command.topic != Topic::pulse) return;
  if (from_charge(reader, command) && reader.given("--duration"))
    reader.complain("--duration", reader.text("--duration"), "and --charge exclude each other",
                    "give --pressure with it");
  if (!reader.given("--pressure")) return;
  for (std::string_view const flag :
       {"--charge", "--distance", "--explosive", "--pressure-factor", "--mass-factor"})
    if (reader.given(flag))
      reader.complain(flag, reader.text(flag), "and --pressure exclude each other");
  if (options.surface_burst)
    reader.complain("--surface-burst", "", "and --pressure exclude each other");
}

void derive_coupling(BlastReader& reader, Situation& situation) {
  if (!std::isnan(situation.coupling)) return;
  double const scaled = situation.depth / situation.size() / blast::foot_per_pound;
  if (scaled >= blast::full_coupling_depth)
    situation.coupling = 1.0;
  else if (std::isnan(situation.depth) || !std::isnan(scaled))
    reader.complain(
        "--coupling", "",
        std::isnan(scaled)
            ? "is missing: of the charge to the ground"
            : fmt::format("is missing: the depth is {:.3g} ft/lb^(1/3), below 2", scaled),
        std::isnan(scaled) ? "give it, or a --depth: from 2 ft/lb^(1/3) on it is 1"
                           : "give a number of at most 1");
}

void derive_front(BlastReader const& reader, BlastOptions const& options, Topic topic,
                  BlastInput& input, double& impulse) {
  Situation& s = input.situation;
  auto const burst = options.surface_burst ? blast::Burst::surface : blast::Burst::free_air;
  Situation const standard = blast::at_sea_level(s);
  auto const here = [&](Kind kind) { return blast::sachs_factor(kind, s.air); };
  double const z = standard.scaled_distance();
  s.overpressure =
      here(Kind::pressure) * s.explosive_factor * blast::kingery_overpressure(burst, z);
  blast::ScaledRange range = blast::kingery_range(burst);
  std::string what = "peak";
  if (topic == Topic::pulse) {
    s.duration = here(Kind::time) * standard.size() * blast::kingery_duration(burst, z);
    range = blast::kingery_duration_range(burst);
    what = "peak and duration";
    if (std::isnan(s.decay) && !reader.given("--impulse")) {
      impulse = here(Kind::impulse) * s.explosive_factor * standard.size() *
                blast::kingery_impulse(burst, z);
      what = "peak, duration and impulse";
    }
  }
  input.notes.push_back(fmt::format("{} by kingery_bulmash", what));
  if (z < range.low || z > range.high)
    input.notes.push_back(
        fmt::format("warning: that is outside its range: R/W^(1/3) is {:.4g} m/kg^(1/3), it holds "
                    "for {:.4g} to {:.4g}",
                    z, range.low, range.high));
  if (!s.air_is_standard())
    input.notes.push_back(fmt::format("warning: that was {}", blast::sachs_caution));
}

void derive_decay(BlastReader& reader, BlastInput& input, double impulse) {
  Situation& s = input.situation;
  if (std::isnan(impulse) || std::isnan(s.duration)) return;
  if (auto const k = blast::friedlander_decay(s.overpressure, s.duration, impulse))
    s.decay = *k;
  else if (reader.given("--impulse"))
    reader.complain("--impulse", reader.text("--impulse"),
                    "fits no decay: it must be above zero and at most half of peak times duration");
  else
    input.notes.emplace_back("warning: that impulse fits no decay of Friedlander's history");
}

}  // namespace moraine
