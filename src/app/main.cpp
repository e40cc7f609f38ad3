// The command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "app/commands.hpp"
#include "base/input_error.hpp"

namespace {

struct Options {
  moraine::RunOptions run;
  moraine::PlotOptions plot;
};

void add_run(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand("run", "run a case");
  command->add_option("case", options.run.case_file, "case file (TOML)")->required();
  command->add_option("--output,-o", options.run.output,
                      "folder for results (default: out/<name of the case>)");
  command->add_option("--threads,-t", options.run.threads, "number of threads (default: all)")
      ->check(CLI::NonNegativeNumber);
}

void add_plot(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand("plot", "draw gauges, sums and particle frames of a run");
  command->add_option("folder", options.plot.folder, "folder of a run")->required();
  command->add_option("--field", options.plot.field, "field that colours the particles")
      ->capture_default_str();
}

int dispatch(CLI::App const& app, Options const& options) {
  if (app.got_subcommand("run")) return moraine::run_case(options.run);
  return moraine::plot_folder(options.plot);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Moraine: particles for extreme events in civil, geotechnical and ocean engineering"};
  app.set_version_flag("--version", MORAINE_VERSION);
  app.require_subcommand(1);
  Options options;
  add_run(app, options);
  add_plot(app, options);
  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    return app.exit(error) == 0 ? 0 : moraine::ExitCode::bad_input;
  }
  try {
    return dispatch(app, options);
  } catch (moraine::InputErrors const& errors) {
    fmt::print(stderr, "{}\n", errors.what());
    return moraine::ExitCode::bad_input;
  } catch (std::exception const& error) {
    fmt::print(stderr, "moraine: {}\n", error.what());
    return moraine::ExitCode::failed;
  }
}
