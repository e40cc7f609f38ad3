#include "app/blast_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/blast_input.hpp"
#include "app/blast_topics.hpp"
#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "blast/explosive.hpp"
#include "output/blast/answer_json.hpp"
#include "output/blast/answer_text.hpp"
#include "output/blast/facts.hpp"
#include "output/blast/series.hpp"

namespace moraine {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view shared_examples =
    "moraine blast --list\nmoraine blast crater --list --json";

std::string footer(std::string_view examples) {
  std::string text = "Examples:";
  for (std::size_t at = 0; at <= examples.size();) {
    std::size_t const end = std::min(examples.find('\n', at), examples.size());
    text += fmt::format("\n  {}", examples.substr(at, end - at));
    at = end + 1;
  }
  return text;
}

void add_value(CLI::App& command, BlastOptions& options, std::string_view flag,
               std::string const& help) {
  command.add_option(std::string(flag), options.values[std::string(flag)], help);
}

template <class Entries>
std::string names_of(Entries const& entries) {
  std::string text;
  for (auto const& entry : entries)
    text += fmt::format("{}{}", text.empty() ? ": " : ", ", entry.name);
  return text;
}

/// The names that an option takes in a topic, behind a colon; none where it takes no names.
std::string choices(std::string_view flag, blast::Topic topic) {
  if (flag == "--explosive") return names_of(blast::explosives());
  if (flag == "--soil") return names_of(blast::soils());
  if (flag != "--ground") return {};
  return topic == blast::Topic::displacement ? names_of(blast::displaced_grounds())
                                             : names_of(blast::broken_grounds());
}

/// ", as in "2 kg"".
std::string example(Dimension const& dimension) {
  return dimension.unit == "1" ? std::string()
                               : fmt::format(", as in \"2 {}\"", dimension.usual[0]);
}

void add_topic(CLI::App& blast, TopicCommand const& topic, BlastOptions& options) {
  auto* command =
      blast.add_subcommand(std::string(blast::name_of(topic.topic)), std::string(topic.help));
  for (QuantityOption const& option : quantity_options())
    if (topic.uses(option.flag))
      add_value(*command, options, option.flag,
                std::string(option.help) + example(option.dimension));
  for (NameOption const& option : name_options())
    if (topic.uses(option.flag))
      add_value(*command, options, option.flag,
                std::string(option.help) + choices(option.flag, topic.topic));
  command
      ->add_option(
          std::string(topic.sweep.flag), options.sweep,
          fmt::format("instead of {}: first, last, number of values", topic.sweep.replaces))
      ->expected(1, 3);
  if (topic.uses("--surface-burst"))
    command->add_flag("--surface-burst", options.surface_burst,
                      "the charge lies on the ground, not in free air");
  add_value(*command, options, "--units", "units of results: si, metric or imperial");
  for (OutputUnitOption const& option : output_unit_options())
    add_value(
        *command, options, option.flag,
        fmt::format("unit of such results, as in \"{}\"", blast::dimension(option.kind).usual[1]));
  add_value(*command, options, "--csv", "write a table to this file (SI)");
  add_value(*command, options, "--plot", "draw to this file, .svg or .png");
  command->add_flag("--force", options.force, "replace files that exist");
  command->add_flag("--json", options.json, "results as JSON (SI)");
  command->add_flag("--list", options.list, "relations of this topic, with sources and ranges");
  command->footer(footer(topic.examples));
  command->allow_extras();
}

/// All relations, or those of a topic.
std::span<blast::Relation const> relations_of(TopicCommand const* topic) {
  auto const all = blast::relations();
  if (topic == nullptr) return all;
  auto const first = std::ranges::find(all, topic->topic, &blast::Relation::topic);
  auto const last = std::find_if(first, all.end(), [&](blast::Relation const& relation) {
    return relation.topic != topic->topic;
  });
  return {first, last};
}

int list(TopicCommand const* topic, bool json) {
  auto const chosen = relations_of(topic);
  if (json)
    fmt::print("{}\n", blast::to_json(chosen).dump(2));
  else
    fmt::print("{}", blast::list_text(chosen));
  return ExitCode::done;
}

/// "charge 10 kg, distance 5 m", as written.
std::string as_written(TopicCommand const& topic, BlastOptions const& options) {
  std::string text;
  auto const add = [&](std::string_view flag) {
    auto const found = options.values.find(std::string(flag));
    if (!topic.uses(flag) || found == options.values.end() || found->second.empty()) return;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", flag.substr(2), found->second);
  };
  for (QuantityOption const& option : quantity_options()) add(option.flag);
  for (NameOption const& option : name_options())
    if (option.flag != "--gauges") add(option.flag);  // a path makes no title
  return text;
}

std::string title(TopicCommand const& topic, BlastOptions const& options) {
  return fmt::format("{}: {}", topic.help, as_written(topic, options));
}

/// Inputs in SI.
Json input_json(TopicCommand const& topic, BlastInput const& input) {
  Json json = Json::object();
  blast::Situation situation = input.situation;
  for (QuantityOption const& option : quantity_options())
    if (double const value = option.target(situation);
        topic.uses(option.flag) && std::isfinite(value))
      json[std::string(option.flag.substr(2))] = value;
  json["explosive-factor"] = situation.explosive_factor;
  if (situation.soil != nullptr) json["soil"] = situation.soil->name;
  if (situation.displaced != nullptr) json["ground"] = situation.displaced->name;
  if (situation.broken != nullptr) json["ground"] = situation.broken->name;
  return json;
}

Json head(TopicCommand const& topic, BlastInput const& input) {
  return {{"topic", blast::name_of(topic.topic)},
          {"input", input_json(topic, input)},
          {"notes", input.notes}};
}

int answer_once(TopicCommand const& topic, BlastOptions const& options, BlastInput const& input) {
  blast::Answer const answer = blast::answer(topic.topic, input.situation);
  if (options.json) {
    Json json = head(topic, input);
    json.update(blast::to_json(answer, input.units));
    if (!input.gauge.gauge.empty())
      json["gauge"] = blast::to_json(input.gauge, answer, input.units);
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
  }
  fmt::print("{}\n", title(topic, options));
  for (std::string const& fact : blast::facts(topic.topic, input.situation, input.units.system))
    fmt::print("{}\n", fact);
  for (std::string const& note : input.notes) fmt::print("{}\n", note);
  fmt::print("{}", blast::answer_text(answer, input.units, input.gauge));
  return ExitCode::done;
}

blast::Series series_of(TopicCommand const& topic, BlastInput const& input) {
  Sweep const& sweep = input.sweep;
  blast::Series series{
      std::string(topic.sweep.variable), sweep.unit, topic.sweep.logarithmic, sweep.points, {}};
  for (double const point : sweep.points) {
    blast::Situation situation = input.situation;
    sweep.target(situation) = point * sweep.factor;
    series.answers.push_back(blast::answer(topic.topic, situation));
  }
  return series;
}

int answer_along(TopicCommand const& topic, BlastOptions const& options, BlastInput const& input) {
  blast::Series const series = series_of(topic, input);
  std::string const& csv = options.values.at("--csv");
  std::string const& plot = options.values.at("--plot");
  if (!csv.empty()) blast::write_csv(csv, series, input.units);
  if (!plot.empty()) {
    blast::OutputUnits units = input.units;  // SI of a table is no unit for a picture
    if (options.values.at("--units").empty()) units.system = blast::UnitSystem::metric;
    blast::draw_series(plot, title(topic, options), series, units);
  }
  if (options.json) {
    Json json = head(topic, input);
    json["variable"] = series.variable;
    json["unit"] = series.unit;
    for (std::size_t i = 0; i < series.points.size(); ++i) {
      Json point{{"at", series.points[i]}};
      point.update(blast::to_json(series.answers[i], input.units));
      json["points"].push_back(std::move(point));
    }
    fmt::print("{}\n", json.dump(2));
    return ExitCode::done;
  }
  for (std::string const* file : {&csv, &plot})
    if (!file->empty()) fmt::print("{}\n", *file);
  bool const to_files = !csv.empty() || !plot.empty();
  if (!to_files) fmt::print("{}\n", title(topic, options));
  for (std::string const& note : input.notes) fmt::print("{}\n", note);
  if (to_files) return ExitCode::done;
  fmt::print("{}", blast::series_text(series, input.units));
  return ExitCode::done;
}

[[noreturn]] void refuse_topic(std::string const& wanted) {
  std::vector<std::string_view> known;
  for (TopicCommand const& topic : topic_commands()) known.push_back(blast::name_of(topic.topic));
  throw InputErrors({{"moraine blast", 0, 0, "", fmt::format("\"{}\"", wanted), "is not a topic",
                      name_hint(wanted, known)}});
}

int run_topic(TopicCommand const& topic, BlastOptions const& options) {
  if (options.list) return list(&topic, options.json);
  BlastInput const input = read_blast_input(topic, options);
  return input.sweep.points.empty() ? answer_once(topic, options, input)
                                    : answer_along(topic, options, input);
}

}  // namespace

void add_blast_command(CLI::App& app, BlastOptions& options) {
  auto* blast = app.add_subcommand(
      "blast", "answers about explosions from published relations, without a simulation");
  blast->require_subcommand(0, 1);
  blast->allow_extras();
  blast->add_flag("--list", options.list, "all relations, with sources and ranges");
  blast->add_flag("--json", options.json, "with --list: as JSON");
  for (TopicCommand const& topic : topic_commands()) add_topic(*blast, topic, options);
  blast->footer(footer(shared_examples));
}

std::optional<int> run_blast_command(CLI::App const& app, BlastOptions options) {
  if (!app.got_subcommand("blast")) return std::nullopt;
  CLI::App const& blast = *app.get_subcommand("blast");
  for (TopicCommand const& topic : topic_commands()) {
    std::string const name(blast::name_of(topic.topic));
    if (!blast.got_subcommand(name)) continue;
    options.extras = blast.get_subcommand(name)->remaining();
    return run_topic(topic, options);
  }
  if (auto const extras = blast.remaining(); !extras.empty()) refuse_topic(extras.front());
  if (options.list) return list(nullptr, options.json);
  fmt::print("{}", blast.help("moraine"));
  return ExitCode::done;
}

}  // namespace moraine
