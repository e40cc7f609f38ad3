#include "app/case_commands.hpp"

#include <fmt/core.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "output/checkpoint/start_reader.hpp"
#include "output/references.hpp"
#include "setup/case_report.hpp"
#include "setup/explain.hpp"
#include "setup/explain_step.hpp"
#include "setup/json_schema.hpp"
#include "setup/materials.hpp"
#include "setup/read_case.hpp"
#include "setup/starters.hpp"

namespace moraine {
namespace {

void add_check(CLI::App& app, CaseCommandOptions& options) {
  auto* command = app.add_subcommand(
      "check",
      "tell all mistakes of a case, or its size, cost and doubts; runs and writes nothing");
  command->add_option("case", options.case_file, "case file (TOML)")->required();
  command->add_flag("--json", options.json, "report as JSON");
  command->add_option("--threads,-t", options.threads, "number of threads (default: all)")
      ->check(CLI::Range(0, 1024));
}

void add_explain(CLI::App& app, CaseCommandOptions& options) {
  auto* command = app.add_subcommand("explain", "say what a key of a case file means");
  command->add_option("key", options.name, "key or table (default: list all)");
  command->add_option("--step", options.case_file, "the actions of a time step of this case");
  command->add_flag("--reference", options.reference, "the reference page, as Markdown");
}

void add_others(CLI::App& app, CaseCommandOptions& options) {
  auto* materials = app.add_subcommand("materials", "list shipped materials, or one with sources");
  materials->add_option("name", options.name, "material (default: list all)");
  auto* starter = app.add_subcommand("new", "write a commented starter case");
  starter->add_option("kind", options.name, "explosion, dam-break, tank or shock-tube")->required();
  starter->add_option("file", options.file, "file to write (default: KIND.toml)");
  app.add_subcommand("schema", "print the JSON Schema of case files, for editors");
}

/// The case with the state that it starts from, if it does.
Case whole_case(std::string const& file) {
  Case c = read_case(file);
  read_start(c);
  check_references(c);
  return c;
}

int check_case(CaseCommandOptions const& options) {
  if (options.threads > 0) omp_set_num_threads(options.threads);
  try {
    CaseReport const report = report_case(whole_case(options.case_file));
    fmt::print("{}{}", options.json ? to_json(report) : to_text(report), options.json ? "\n" : "");
    return ExitCode::done;
  } catch (InputErrors const& errors) {
    if (!options.json) throw;
    fmt::print("{}\n", mistakes_to_json(errors));
    return ExitCode::bad_input;
  }
}

int explain_key(CaseCommandOptions const& options) {
  if (options.reference)
    fmt::print("{}", reference_page());
  else if (!options.case_file.empty())
    fmt::print("{}", explain_step(whole_case(options.case_file)));
  else
    fmt::print("{}", explain(options.name));
  return ExitCode::done;
}

int new_case(CaseCommandOptions const& options) {
  std::string const file = options.file.empty() ? options.name + ".toml" : options.file;
  write_starter(options.name, file);
  fmt::print("{}: moraine check {}, then moraine run {}\n", file, file, file);
  return ExitCode::done;
}

}  // namespace

void add_case_commands(CLI::App& app, CaseCommandOptions& options) {
  add_check(app, options);
  add_explain(app, options);
  add_others(app, options);
}

std::optional<int> run_case_command(CLI::App const& app, CaseCommandOptions const& options) {
  if (app.got_subcommand("check")) return check_case(options);
  if (app.got_subcommand("explain")) return explain_key(options);
  if (app.got_subcommand("new")) return new_case(options);
  if (app.got_subcommand("schema")) {
    fmt::print("{}", json_schema());
    return ExitCode::done;
  }
  if (app.got_subcommand("materials")) {
    fmt::print("{}",
               options.name.empty() ? list_materials() : describe(shipped_material(options.name)));
    return ExitCode::done;
  }
  return std::nullopt;
}

}  // namespace moraine
