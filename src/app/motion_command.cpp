#include "app/motion_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "app/commands.hpp"
#include "app/motion_synthesis.hpp"
#include "output/motion/measure_table.hpp"
#include "output/motion/motion_pictures.hpp"
#include "records/record_writer.hpp"
#include "records/response_spectrum.hpp"
#include "records/spectral_measures.hpp"

namespace moraine {
namespace {

constexpr char const* command_name = "moraine motion";

constexpr char const* examples =
    R"(A record is an .AT2 file of PEER, two columns of time and acceleration, or plain numbers.
Options with units take anything like "0.35 g0" (standard gravity), "20 ms", "9 Hz"; plain numbers
are in SI units. Records are cut, filtered, scaled in time, resampled, corrected and scaled, in this
order.

Examples:
  moraine motion synthesise --pga "0.35 g0" --pgv-pga "0.096 s" --predominant-period "0.28 s" --seed 7 --write quake.csv
  moraine motion quake.csv
  moraine motion quake.csv --pga "0.2 g0" --until "15 s" --baseline rest --plot quake.svg --json
  moraine motion quake.csv --time-scale 0.25 --write model.AT2 --write-displacement table-motion.csv
  moraine motion quake.csv model.AT2 --csv --write-spectra spectra.csv --write-frequencies frequencies.csv
)";

constexpr char const* synthesis_examples =
    R"(Noise is filtered until PGA, PGV/PGA and the predominant period are met; the fit is printed. A motion
that is off by more than 0.5 % is written all the same, with a message and exit code 1.

Examples:
  moraine motion synthesise --pga "0.35 g0" --pgv-pga "28 ms" --predominant-period "0.14 s" --json
  moraine motion synthesise --pga "0.35 g0" --pgv-pga "0.174 s" --predominant-period "0.54 s" --duration "30 s" --seed 7 --write low.AT2
)";

bool is_at2(std::string const& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".at2";
}

SpectrumRange spectrum_range(MotionOptions const& options, std::vector<FileRecord> const& records,
                             UnitOptions& input) {
  SpectrumRange range;
  range.damping = options.damping;
  if (!(options.damping >= 0.0 && options.damping < 1.0))
    input.mistake("--damping", fmt::format("{:g}", options.damping), "is no damping ratio",
                  "choose 0 to below 1, for example 0.05");
  range.longest =
      input.positive("--longest-period", options.longest_period, Quantity::time).value_or(4.0);
  auto const wanted = input.positive("--shortest-period", options.shortest_period, Quantity::time);
  range.shortest = wanted.value_or(0.0);
  for (auto const& [file, record] : records) {
    double const own = shortest_period(record.time_step);
    if (!wanted) range.shortest = std::max(range.shortest, own);
    if (wanted && *wanted < own * (1.0 - 1e-9))
      input.add(file,
                fmt::format("a step of {:.4g} s is too coarse for a spectrum from {:.4g} s",
                            record.time_step, *wanted),
                fmt::format("its shortest period is {:.4g} s, five steps", own));
  }
  if (range.shortest >= range.longest)
    input.mistake("--longest-period", fmt::format("\"{}\"", options.longest_period),
                  fmt::format("is not above the shortest, {:.4g} s", range.shortest));
  return range;
}

void check_steps(std::vector<FileRecord> const& records, UnitOptions& input) {
  for (auto const& [file, record] : records) {
    if (record.time_step > coarsest_measured_step * (1.0 + 1e-9))
      input.add(
          file,
          fmt::format("a step of {:.4g} s is too coarse for the spectra of the measures, which "
                      "begin at 0.1 s",
                      record.time_step),
          fmt::format("steps of {0:g} s or less are needed; --resample \"{0:g} s\" makes "
                      "them, but adds no frequencies",
                      coarsest_measured_step));
    if (peak_of(record, record.acceleration).value == 0.0) input.add(file, "is zero throughout");
  }
}

/// Displacements that go on growing come from the baseline, not from the ground.
void warn_of_drift(GroundRecord const& record) {
  GroundPath const path = integrate(record);
  double const largest = peak_of(record, path.displacement).value;
  double const last = std::fabs(path.displacement.back());
  if (last <= 0.5 * largest) return;
  fmt::print(
      stderr,
      "warning: {}: ends displaced by {:.3g} m at {:.3g} m/s, which is drift more likely than "
      "ground; --baseline corrects it\n",
      record.name, last, std::fabs(path.velocity.back()));
}

/// A predominant period at an end of where it is looked for is none.
void warn_of_period(MeasuredMotion const& motion) {
  double const found = motion.measures.predominant_period;
  double const shortest = shortest_predominant_period(motion.record.time_step);
  if (found > 1.01 * shortest && found < 0.99 * longest_predominant_period) return;
  fmt::print(stderr,
             "warning: {}: the pseudo acceleration is largest at {:.3g} s, an end of the periods "
             "looked at ({:.3g} to {:g} s); the predominant period may lie outside\n",
             motion.record.name, found, shortest, longest_predominant_period);
}

void check_outputs(MotionOptions const& options, UnitOptions& input) {
  MotionOutputs const& out = options.out;
  input.check_output("--write", out.record, out.force);
  input.check_output("--write-displacement", out.displacement, out.force);
  input.check_output("--write-spectra", out.spectra, out.force);
  input.check_output("--write-frequencies", out.frequencies, out.force);
  if (!out.plot.empty())
    for (auto const& file : motion_pictures(out.plot))
      input.check_output("--plot", file.string(), out.force);
  if (options.records.files.size() > 1)
    for (auto const& [option, file] :
         {std::pair{"--write", out.record}, std::pair{"--write-displacement", out.displacement}})
      if (!file.empty())
        input.mistake(option, fmt::format("\"{}\"", file), "is one file for several records",
                      "give one record");
  if (out.axis != "x" && out.axis != "y" && out.axis != "z")
    input.mistake("--axis", fmt::format("\"{}\"", out.axis), "is no axis", "choose x, y or z");
  std::string const ending = std::filesystem::path(out.plot).extension().string();
  if (!out.plot.empty() && ending != ".svg" && ending != ".png")
    input.mistake("--plot", fmt::format("\"{}\"", out.plot), "is no picture",
                  "end its name with .svg or .png");
  if (out.json && out.csv) input.mistake("--csv", "", "is given together with --json");
}

int measure_records(MotionOptions const& options) {
  UnitOptions input(command_name);
  if (options.records.files.empty())
    input.mistake("", "", "a record is missing", "moraine motion --help shows examples");
  std::vector<FileRecord> const files = read_records(options.records, input);
  check_outputs(options, input);
  check_steps(files, input);
  SpectrumRange const range = spectrum_range(options, files, input);
  input.raise();

  std::vector<GroundRecord> const records = without_files(files);
  warn_of_peaks(records);
  std::vector<MeasuredMotion> motions;
  for (auto const& [file, record] : files) try {
      motions.push_back(measured_motion(record));
    } catch (std::invalid_argument const& error) {
      input.add(file, error.what());
    }
  input.raise();
  for (MeasuredMotion const& motion : motions) {
    warn_of_drift(motion.record);
    warn_of_period(motion);
  }
  if (options.out.json)
    fmt::print("{}\n", measures_as_json(motions).dump(2));
  else
    fmt::print("{}", options.out.csv ? measures_as_csv(motions) : measures_as_text(motions));
  write_motion(records.front(), options.out);
  if (!options.out.spectra.empty()) write_text(options.out.spectra, spectra_as_csv(records, range));
  if (!options.out.frequencies.empty())
    write_text(options.out.frequencies, frequencies_as_csv(records));
  if (!options.out.plot.empty())
    for (auto const& file : draw_motions(options.out.plot, records, range))
      fmt::print(stderr, "{}\n", file.string());
  return ExitCode::done;
}

void add_synthesis(CLI::App& motion, MotionOptions& options) {
  auto* command = motion.add_subcommand(
      "synthesise", "make a motion with wanted measures, out of filtered noise");
  command->alias("synthesize");
  SynthesisOptions& s = options.synthesis;
  command->add_option("--pga", s.pga, "largest acceleration, for example \"0.35 g0\"")->required();
  command->add_option("--pgv-pga", s.velocity_ratio, "PGV/PGA, for example \"0.096 s\"")
      ->required();
  command
      ->add_option("--predominant-period", s.predominant_period,
                   "of the largest pseudo acceleration at 5 % damping, for example \"0.28 s\"")
      ->required();
  command->add_option("--duration", s.duration, "of the motion")->capture_default_str();
  command->add_option("--time-step", s.time_step, "of the motion")->capture_default_str();
  command->add_option("--rise", s.rise, "part of the duration in which it rises")
      ->capture_default_str();
  command->add_option("--stay", s.stay, "part of the duration after which it falls")
      ->capture_default_str();
  command->add_option("--seed", s.seed, "of the noise; the same seed gives the same motion")
      ->check([](std::string const& text) {
        return text.starts_with('-') ? text + " is negative" : std::string();
      })
      ->capture_default_str();
  command->footer(synthesis_examples);
  add_motion_outputs(*command, options.out);
}

}  // namespace

void add_motion_outputs(CLI::App& command, MotionOutputs& out) {
  command.add_flag("--json", out.json, "figures as JSON, in SI units")->group("Output");
  command
      .add_option("--write", out.record, "write the motion: .AT2, or two columns for other endings")
      ->group("Output");
  command
      .add_option("--write-displacement", out.displacement,
                  "write the displacement, as motion.file of moving walls takes it")
      ->group("Output");
  command.add_option("--axis", out.axis, "of that displacement: x, y or z")
      ->capture_default_str()
      ->group("Output");
  command.add_flag("--force", out.force, "replace files that exist")->group("Output");
}

void write_motion(GroundRecord const& record, MotionOutputs const& out) {
  if (!out.record.empty())
    write_text(out.record, is_at2(out.record) ? record_as_at2(record) : record_as_csv(record));
  if (!out.displacement.empty())
    write_text(out.displacement, displacement_as_csv(record, out.axis));
}

void add_motion_command(CLI::App& app, MotionOptions& options) {
  auto* command = app.add_subcommand(
      "motion", "measures and spectra of ground motion records; synthetic motions");
  command->add_option("record", options.records.files, "files of records");
  add_record_options(*command, options.records);
  command
      ->add_option("--shortest-period", options.shortest_period,
                   "of response spectra (default: five steps)")
      ->group("Spectra");
  command->add_option("--longest-period", options.longest_period, "of response spectra")
      ->capture_default_str()
      ->group("Spectra");
  command->add_option("--damping", options.damping, "ratio, of response spectra")
      ->capture_default_str()
      ->group("Spectra");
  command->add_flag("--csv", options.out.csv, "the table as CSV")->group("Output");
  add_motion_outputs(*command, options.out);
  command->add_option("--write-spectra", options.out.spectra, "write response spectra as CSV")
      ->group("Output");
  command
      ->add_option("--write-frequencies", options.out.frequencies,
                   "write Fourier and power spectra as CSV")
      ->group("Output");
  command
      ->add_option("--plot", options.out.plot,
                   "draw NAME.svg or .png, NAME-spectra and NAME-frequencies")
      ->group("Output");
  command->footer(examples);
  add_synthesis(*command, options);
}

std::optional<int> run_motion_command(CLI::App const& app, MotionOptions const& options) {
  if (!app.got_subcommand("motion")) return std::nullopt;
  if (app.get_subcommand("motion")->got_subcommand("synthesise")) return synthesise_motion(options);
  return measure_records(options);
}

}  // namespace moraine
