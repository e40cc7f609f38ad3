#include "app/slosh_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "app/commands.hpp"
#include "output/sloshing/tank_pictures.hpp"
#include "output/sloshing/tank_table.hpp"

namespace moraine {
namespace {

constexpr char const* command_name = "moraine slosh";

constexpr char const* examples =
    R"(The tank is rectangular, rigid and open, and is moved along its length; the force of the liquid on it
counts along the motion, without weight. Options with units take anything like "2.2 m", "9.81 m/s^2",
"0.35 g0" (standard gravity); plain numbers are in SI units. Records are read and processed as by
moraine motion.

Examples:
  moraine slosh --length 2.2 --depth 0.7 --width 1.15
  moraine motion synthesise --pga "0.35 g0" --pgv-pga "0.096 s" --predominant-period "0.28 s" --write quake.csv
  moraine slosh --length "2.2 m" --depth "70 cm" --record quake.csv --pga "0.05 g0" --plot slosh.svg
  moraine slosh --length 20 --depth 9 --record quake.csv --free-time "30 s" --write history.csv --json
)";

struct Request {
  TankReport report;
  std::vector<GroundRecord> records;
  double freeboard = 0.0;
};

Request read_request(SloshOptions const& o, UnitOptions& input) {
  Request request;
  RigidTank& tank = request.report.tank;
  auto const take = [&](double& value, char const* option, std::string const& text, Quantity q) {
    if (text.empty()) input.mistake(option, "\"\"", "has no value");
    if (auto const read = input.positive(option, text, q)) value = *read;
  };
  take(tank.length, "--length", o.length, Quantity::length);
  take(tank.depth, "--depth", o.depth, Quantity::length);
  take(tank.width, "--width", o.width, Quantity::length);
  take(tank.density, "--density", o.density, Quantity::density);
  take(tank.gravity, "--gravity", o.gravity, Quantity::acceleration);
  if (tank.length > 0.0 && tank.depth > 0.0) try {
      check_tank(tank);
    } catch (std::invalid_argument const& error) {
      input.add(command_name, error.what());
    }
  request.freeboard = input.positive("--freeboard", o.freeboard, Quantity::length).value_or(0.0);
  request.report.modes = o.modes;
  ResponseSettings& settings = request.report.settings;
  settings.modes = o.summed_modes;
  settings.damping = o.damping;
  settings.free_time = input.not_negative("--free-time", o.free_time, Quantity::time).value_or(0.0);
  if (!(o.damping >= 0.0 && o.damping < 1.0))
    input.mistake("--damping", fmt::format("{:g}", o.damping), "is no damping ratio",
                  "choose 0 to below 1, for example 0.005");
  request.records = without_files(read_records(o.records, input));
  return request;
}

void check_outputs(SloshOptions const& o, UnitOptions& input) {
  std::string const ending = std::filesystem::path(o.plot).extension().string();
  if (!o.plot.empty() && ending != ".svg" && ending != ".png")
    input.mistake("--plot", fmt::format("\"{}\"", o.plot), "is no picture",
                  "end its name with .svg or .png");
  for (auto const& [option, file] : {std::pair{"--write", o.history}, std::pair{"--plot", o.plot}})
    if (!file.empty() && o.records.files.empty())
      input.mistake(option, fmt::format("\"{}\"", file), "needs a record", "add --record FILE");
  if (!o.history.empty() && o.records.files.size() > 1)
    input.mistake("--write", fmt::format("\"{}\"", o.history), "is one file for several records",
                  "give one record");
  input.check_output("--write", o.history, o.force);
  input.check_output("--plot", o.plot, o.force);
  if (o.json && o.csv) input.mistake("--csv", "", "is given together with --json");
}

int report_tank(SloshOptions const& options) {
  UnitOptions input(command_name);
  Request request = read_request(options, input);
  check_outputs(options, input);
  input.raise();
  TankReport& report = request.report;
  for (GroundRecord const& record : request.records) try {
      report.responses.push_back(tank_response(report.tank, record, report.settings));
    } catch (std::invalid_argument const& error) {
      input.add(record.name, error.what());
    }
  input.raise();
  if (options.json)
    fmt::print("{}\n", tank_as_json(report).dump(2));
  else
    fmt::print("{}", options.csv ? tank_as_csv(report) : tank_as_text(report));
  warn_of_peaks(request.records);
  for (std::string const& doubt : response_doubts(report, request.freeboard))
    fmt::print(stderr, "warning: {}\n", doubt);
  if (!options.history.empty())
    write_text(options.history, response_as_csv(report.responses.front()));
  if (!options.plot.empty()) {
    draw_tank_responses(options.plot, report.responses);
    fmt::print(stderr, "{}\n", options.plot);
  }
  return ExitCode::done;
}

}  // namespace

void add_slosh_command(CLI::App& app, SloshOptions& options) {
  auto* command =
      app.add_subcommand("slosh", "waves, masses and forces of a rigid tank by linear theory");
  command->add_option("--length", options.length, "clear, along the motion")->required();
  command->add_option("--depth", options.depth, "of the liquid")->required();
  command->add_option("--width", options.width, "clear, across the motion")->capture_default_str();
  command->add_option("--density", options.density, "of the liquid")->capture_default_str();
  command->add_option("--gravity", options.gravity, "of the place")->capture_default_str();
  command->add_option("--freeboard", options.freeboard,
                      "walls above still water: warns of spilling");
  command->add_option("--modes", options.modes, "modes to list")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--record", options.records.files, "ground motions that act along the length")
      ->group("Response");
  command->add_option("--damping", options.damping, "ratio of all modes")
      ->capture_default_str()
      ->group("Response");
  command->add_option("--summed-modes", options.summed_modes, "odd modes that are summed")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str()
      ->group("Response");
  command->add_option("--free-time", options.free_time, "time after the record, at rest")
      ->group("Response");
  add_record_options(*command, options.records);
  command->add_flag("--json", options.json, "figures as JSON, in SI units")->group("Output");
  command->add_flag("--csv", options.csv, "modes, or responses to records, as CSV")
      ->group("Output");
  command->add_option("--write", options.history, "write the histories of a response as CSV")
      ->group("Output");
  command->add_option("--plot", options.plot, "draw the responses: .svg or .png")->group("Output");
  command->add_flag("--force", options.force, "replace files that exist")->group("Output");
  command->footer(examples);
}

std::optional<int> run_slosh_command(CLI::App const& app, SloshOptions const& options) {
  if (!app.got_subcommand("slosh")) return std::nullopt;
  return report_tank(options);
}

}  // namespace moraine
