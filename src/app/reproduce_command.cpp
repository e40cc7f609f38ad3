#include "app/reproduce_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/published_study.hpp"
#include "app/unit_options.hpp"
#include "base/input_error.hpp"
#include "output/run_folder.hpp"
#include "output/table_csv.hpp"
#include "verify/shipped_cases.hpp"

namespace moraine {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

PublishedStudy const& study_of(std::string const& name) {
  std::vector<std::string_view> names;
  for (PublishedStudy const& study : published_studies()) {
    if (study.name == name) return study;
    names.push_back(study.name);
  }
  throw InputErrors({{"moraine reproduce", 0, 0, "", fmt::format("\"{}\"", name),
                      "is no study that can be reproduced", name_hint(name, names)}});
}

std::vector<std::string_view> cases_of(PublishedStudy const& study) {
  std::vector<std::string_view> names;
  for (PublishedNumber const& number : study.numbers)
    if (std::find(names.begin(), names.end(), number.case_name) == names.end())
      names.push_back(number.case_name);
  return names;
}

/// The case file as the program ships it, in the folder of the study.
std::filesystem::path write_case(std::filesystem::path const& folder, std::string_view name) {
  for (EmbeddedText const& shipped : shipped_cases()) {
    if (shipped.name != name) continue;
    std::filesystem::create_directories(folder);
    auto const file = folder / (std::string(name) + ".toml");
    write_text(file.string(), std::string(shipped.text));
    return file;
  }
  throw std::logic_error("a study names a case that is not shipped");
}

/// Value of a column at a time, by linear interpolation; no number beyond the readings.
double at_time(std::vector<double> const& times, std::vector<double> const& values, double time) {
  auto const later = std::lower_bound(times.begin(), times.end(), time);
  if (later == times.end()) return nothing;
  auto const k = static_cast<std::size_t>(later - times.begin());
  if (k == 0) return values.front();
  double const share = (time - times[k - 1]) / (times[k] - times[k - 1]);
  return values[k - 1] + share * (values[k] - values[k - 1]);
}

double taken_of(Table const& gauges, PublishedNumber const& number) {
  auto const* times = gauges.find("time");
  auto const* values = gauges.find(number.column);
  if (times == nullptr || values == nullptr || values->empty()) return nothing;
  if (number.taken == Taken::at_time) return at_time(*times, *values, number.time);
  std::size_t best = values->size();
  for (std::size_t k = 0; k < values->size(); ++k)
    if (!std::isnan((*values)[k]) && (best == values->size() || (*values)[k] > (*values)[best]))
      best = k;
  if (best == values->size()) return nothing;
  return number.taken == Taken::largest ? (*values)[best] : (*times)[best];
}

std::string moment(PublishedNumber const& number) {
  return number.taken == Taken::at_time ? fmt::format(" at {:g} us", number.time * 1e6) : "";
}

std::string shown(double value, std::string_view unit) {
  if (std::isnan(value)) return "-";
  if (unit == "m") return fmt::format("{:.3g} cm", value * 100.0);
  if (unit == "s") return fmt::format("{:.3g} us", value * 1e6);
  return fmt::format("{:.3g} MPa", value * 1e-6);
}

/// Runs the cases whose results are not there, or are those of another case or program.
void run_missing(PublishedStudy const& study, std::filesystem::path const& folder, int threads) {
  for (std::string_view const name : cases_of(study)) {
    auto const results = folder / name;
    auto const file = write_case(folder, name);
    if (has_results_of(results, file_sha256(file), build_info())) {
      fmt::print("{}: there already\n", results.string());
      continue;
    }
    if (holds_a_run(results))
      fmt::print("{}: of another case or program, or not at its end; run again\n",
                 results.string());
    std::fflush(stdout);
    RunOptions run;
    run.case_file = file.string();
    run.output = results.string();
    run.threads = threads;
    run.force = true;
    if (int const code = run_case(run); code != ExitCode::done)
      throw std::runtime_error(fmt::format("the case {} did not come to its end", name));
  }
}

/// One line of the table as a line of CSV, in SI units; without a number of ours the fields that
/// take one are empty.
std::string csv_line(PublishedNumber const& number, double ours, double difference) {
  auto const field = [](double value) {
    return std::isnan(value) ? std::string() : fmt::format("{}", value);
  };
  return fmt::format("{},{},{},{},{},{}\n", csv_field(number.case_name),
                     csv_field(std::string(number.what) + moment(number)), number.unit, field(ours),
                     number.value, field(difference));
}

/// Prints our numbers beside those of the study; returns the same as CSV.
std::string compare(PublishedStudy const& study, std::filesystem::path const& folder) {
  std::map<std::string_view, Table> gauges;
  for (std::string_view const name : cases_of(study))
    gauges.emplace(name, read_table_csv(folder / name / "gauges.csv"));
  std::string csv = "case,quantity,unit,ours,printed,difference\n";
  fmt::print("\n{}: {}\n\n{:<22}{:<36}{:>12}{:>12}{:>12}  {}\n", study.name, study.source, "case",
             "quantity", "ours", "printed", "difference", "note");
  for (PublishedNumber const& number : study.numbers) {
    double const ours = taken_of(gauges.at(number.case_name), number);
    double const difference = (ours - number.value) / number.value;
    fmt::print("{:<22}{:<36}{:>12}{:>12}{:>12}  {}\n", number.case_name,
               std::string(number.what) + moment(number), shown(ours, number.unit),
               shown(number.value, number.unit),
               std::isnan(ours) ? "-" : fmt::format("{:+.0f} %", 100.0 * difference), number.note);
    csv += csv_line(number, ours, difference);
  }
  return csv;
}

int reproduce(ReproduceOptions const& options) {
  if (options.study.empty()) {
    for (PublishedStudy const& study : published_studies())
      fmt::print("{:<15}{}\n", study.name, study.source);
    return ExitCode::done;
  }
  PublishedStudy const& study = study_of(options.study);
  std::filesystem::path const folder =
      options.output.empty() ? "out/" + options.study : options.output;
  run_missing(study, folder, options.threads);
  std::string const csv = compare(study, folder);
  fmt::print("\n{}", study.reasons);
  if (!options.csv.empty()) write_text(options.csv, csv);
  return ExitCode::done;
}

}  // namespace

void add_reproduce_command(CLI::App& app, ReproduceOptions& options) {
  auto* command = app.add_subcommand(
      "reproduce", "run the cases of a published study and set our numbers beside its own");
  command->add_option("study", options.study, "study (default: list them)");
  command->add_option("--output,-o", options.output,
                      "folder for the runs (default: out/<study>); finished ones of the same case "
                      "and program are kept");
  command->add_option("--csv", options.csv, "write the numbers to this file");
  command->add_option("--threads,-t", options.threads, "number of threads (default: all)")
      ->check(CLI::Range(0, 1024));
}

std::optional<int> run_reproduce_command(CLI::App const& app, ReproduceOptions const& options) {
  if (!app.got_subcommand("reproduce")) return std::nullopt;
  return reproduce(options);
}

}  // namespace moraine
