#include "app/blast_input.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/blast_derived.hpp"
#include "app/blast_reader.hpp"
#include "blast/explosive.hpp"

namespace moraine {
namespace {

using blast::Kind;
using blast::Situation;
using blast::Topic;

constexpr std::size_t most_points = 10000;

void require(BlastReader& reader, TopicCommand const& command, BlastOptions const& options) {
  bool const charge = from_charge(reader, command);
  std::string_view const required = charge ? "--charge --distance" : command.required;
  for (QuantityOption const& option : quantity_options()) {
    bool const swept = !options.sweep.empty() && option.flag == command.sweep.replaces;
    if (!holds(required, option.flag) || swept || reader.given(option.flag)) continue;
    bool const other = option.flag == "--pressure" && command.uses("--charge");
    reader.complain(option.flag, "", fmt::format("is missing: {}", option.help),
                    fmt::format("give {}{}", option.dimension.name,
                                other ? ", or --charge and --distance" : ""));
  }
  for (NameOption const& option : name_options())
    if (holds(required, option.flag) && !reader.given(option.flag))
      reader.complain(option.flag, "", fmt::format("is missing: {}", option.help));
  if (command.sweep.replaces.empty() || options.sweep.empty()) return;
  if (reader.given(command.sweep.replaces))
    reader.complain(command.sweep.replaces, reader.text(command.sweep.replaces),
                    fmt::format("and {} exclude each other", command.sweep.flag));
}

std::vector<std::string_view> known_flags(TopicCommand const& command) {
  std::vector<std::string_view> known{"--units", "--csv",  "--plot",  "--json",
                                      "--list",  "--help", "--force", command.sweep.flag};
  for (QuantityOption const& option : quantity_options())
    if (command.uses(option.flag)) known.push_back(option.flag);
  for (NameOption const& option : name_options())
    if (command.uses(option.flag)) known.push_back(option.flag);
  for (OutputUnitOption const& option : output_unit_options()) known.push_back(option.flag);
  if (command.uses("--surface-burst")) known.push_back("--surface-burst");
  return known;
}

/// Factors of the explosive; the mass factor is returned.
double read_explosive(BlastReader& reader, Situation& situation) {
  double mass_factor = 1.0;
  if (reader.given("--explosive"))
    if (auto const* found = reader.entry("--explosive", blast::explosives())) {
      situation.explosive_factor = found->pressure_factor;
      mass_factor = found->mass_factor;
    }
  if (reader.given("--pressure-factor"))
    situation.explosive_factor = reader.factor("--pressure-factor").value_or(1.0);
  if (reader.given("--mass-factor")) mass_factor = reader.factor("--mass-factor").value_or(1.0);
  return mass_factor;
}

void read_lists(BlastReader& reader, TopicCommand const& command, Situation& situation) {
  if (reader.given("--soil")) situation.soil = reader.entry("--soil", blast::soils());
  if (!reader.given("--ground")) return;
  if (command.topic == Topic::displacement)
    situation.displaced = reader.entry("--ground", blast::displaced_grounds());
  else
    situation.broken = reader.entry("--ground", blast::broken_grounds());
}

/// The unit behind the number of a value that was read already.
std::string unit_text(std::string_view text) {
  double ignored = 0.0;
  text.remove_prefix(std::min(text.find_first_not_of(" +"), text.size()));
  auto const end = std::from_chars(text.data(), text.data() + text.size(), ignored).ptr;
  std::string_view unit = text.substr(static_cast<std::size_t>(end - text.data()));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  return std::string(unit);
}

std::optional<std::size_t> read_count(BlastReader& reader, std::string_view flag,
                                      std::string const& text) {
  std::size_t count = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size() && count >= 2 &&
      count <= most_points)
    return count;
  reader.complain(flag, text, fmt::format("is not a number of points from 2 to {}", most_points));
  return std::nullopt;
}

Sweep read_sweep(BlastReader& reader, SweepOption const& command, BlastOptions const& options) {
  if (options.sweep.size() != 3) {
    reader.complain(std::string(command.flag), options.sweep.front(),
                    "is not all: first value, last value and number of values are expected");
    return {};
  }
  auto const target =
      std::ranges::find(quantity_options(), command.replaces, &QuantityOption::flag);
  QuantityOption option = *target;
  option.flag = command.flag;
  auto const first = reader.quantity(option, options.sweep[0]);
  auto const last = reader.quantity(option, options.sweep[1]);
  auto const count = read_count(reader, command.flag, options.sweep[2]);
  if (!first || !last || !count) return {};
  if (!(*last > *first)) {
    reader.complain(command.flag, options.sweep[1], "must be above the first value");
    return {};
  }
  Sweep sweep;
  sweep.target = option.target;
  sweep.unit = unit_text(options.sweep[0]);
  sweep.factor = *to_si("1 " + sweep.unit, option.dimension).value;
  double const a = *first / sweep.factor, b = *last / sweep.factor;
  for (std::size_t i = 0; i < *count; ++i) {
    double const s = static_cast<double>(i) / static_cast<double>(*count - 1);
    sweep.points.push_back(command.logarithmic ? a * std::pow(b / a, s) : a + s * (b - a));
  }
  sweep.points.back() = b;
  return sweep;
}

blast::OutputUnits read_units(BlastReader& reader, BlastOptions const& options) {
  blast::OutputUnits units;
  bool const for_programs = options.json || reader.given("--csv");
  units.system = for_programs ? blast::UnitSystem::si : blast::UnitSystem::metric;
  std::string const& system = reader.text("--units");
  constexpr std::string_view systems[] = {"si", "metric", "imperial"};
  auto const found = std::ranges::find(systems, system);
  if (found != std::end(systems))
    units.system = static_cast<blast::UnitSystem>(found - std::begin(systems));
  else if (!system.empty())
    reader.complain("--units", system, "is not a system of units", name_hint(system, systems));
  for (auto const& [flag, kind] : output_unit_options()) {
    std::string const& unit = reader.text(flag);
    if (unit.empty()) continue;
    Conversion const one = to_si("1 " + unit, blast::dimension(kind));
    if (!one.value) reader.complain(flag, unit, one.rule, one.hint);
    units.chosen[static_cast<std::size_t>(kind)] = unit;
  }
  return units;
}

void check_files(BlastReader& reader, TopicCommand const& command, BlastOptions const& options) {
  for (std::string_view const file : {"--csv", "--plot"})
    if (reader.given(file) && options.sweep.empty())
      reader.complain(file, "", "needs a range of values",
                      fmt::format("add {} FIRST LAST COUNT", command.sweep.flag));
  std::string const& plot = reader.text("--plot");
  if (!plot.empty() && !plot.ends_with(".svg") && !plot.ends_with(".png"))
    reader.complain("--plot", plot, "must end in .svg or .png");
  if (!plot.empty() && plot == reader.text("--csv"))
    reader.complain("--plot", plot, "is the file of --csv too", "name another file");
  for (std::string_view const file : {"--csv", "--plot"}) reader.keep_existing(file);
}

blast::GaugeReadings read_gauge_option(BlastReader& reader, BlastOptions const& options) {
  std::string const &file = reader.text("--gauges"), &gauge = reader.text("--gauge");
  if (file.empty() && gauge.empty()) return {};
  if (!options.sweep.empty())
    reader.complain("--gauges", file, "stands at one distance, not along a range");
  if (file.empty()) reader.complain("--gauges", "", "is missing: gauges.json of the run");
  if (gauge.empty()) reader.complain("--gauge", "", "is missing: which gauge of the run");
  if (file.empty() || gauge.empty()) return {};
  try {
    return blast::read_gauge(file, gauge);
  } catch (InputErrors const& errors) {
    reader.complain(errors);
    return {};
  }
}

}  // namespace

BlastInput read_blast_input(TopicCommand const& command, BlastOptions const& options) {
  BlastReader reader(fmt::format("moraine blast {}", name_of(command.topic)), options);
  BlastInput input;
  Situation& situation = input.situation;
  reader.refuse(options.extras, known_flags(command));
  require(reader, command, options);
  refuse_two_fronts(reader, command, options);
  for (QuantityOption const& option : quantity_options())
    if (command.uses(option.flag) && reader.given(option.flag))
      option.target(situation) =
          reader.quantity(option, reader.text(option.flag)).value_or(blast::unknown);
  double const mass_factor = read_explosive(reader, situation);
  situation.charge_mass *= mass_factor;
  read_lists(reader, command, situation);
  input.units = read_units(reader, options);
  if (!options.sweep.empty()) {
    input.sweep = read_sweep(reader, command.sweep, options);
    if (command.sweep.replaces == "--charge") input.sweep.factor *= mass_factor;
  }
  check_files(reader, command, options);
  input.gauge = read_gauge_option(reader, options);
  double impulse = blast::unknown;
  if (reader.given("--impulse")) {
    Conversion const read = to_si(reader.text("--impulse"), blast::dimension(Kind::impulse));
    if (!read.value) reader.complain("--impulse", reader.text("--impulse"), read.rule, read.hint);
    impulse = read.value.value_or(blast::unknown);
    if (reader.given("--decay"))
      reader.complain("--decay", reader.text("--decay"), "and --impulse exclude each other");
  }
  reader.finish();
  if (from_charge(reader, command)) derive_front(reader, options, command.topic, input, impulse);
  if (command.topic == Topic::pulse) derive_decay(reader, input, impulse);
  if (command.topic == Topic::buried) derive_coupling(reader, situation);
  reader.finish();
  return input;
}

}  // namespace moraine
