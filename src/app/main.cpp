// The command line.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "app/blast_command.hpp"
#include "app/case_commands.hpp"
#include "app/commands.hpp"
#include "app/exact_command.hpp"
#include "app/motion_command.hpp"
#include "app/point_command.hpp"
#include "app/report_command.hpp"
#include "app/reproduce_command.hpp"
#include "app/slosh_command.hpp"
#include "app/sweep_command.hpp"
#include "app/watch_command.hpp"
#include "base/input_error.hpp"
#include "output/output_error.hpp"

namespace {

struct Options {
  moraine::RunOptions run;
  moraine::ResumeOptions resume;
  moraine::PreviewOptions preview;
  moraine::PlotOptions plot;
  moraine::SurfaceOptions surface;
  moraine::BenchOptions bench;
  moraine::VerifyOptions verify;
  moraine::ExactOptions exact;
  moraine::CaseCommandOptions cases;
  moraine::BlastOptions blast;
  moraine::MotionOptions motion;
  moraine::PointOptions point;
  moraine::SloshOptions slosh;
  moraine::ReportCommandOptions report;
  moraine::ReproduceOptions reproduce;
  moraine::WatchOptions watch;
  moraine::SweepOptions sweep;
};

void add_run(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand("run", "run a case");
  command->add_option("case", options.run.case_file, "case file (TOML)")->required();
  command->add_option("--output,-o", options.run.output,
                      "folder for results (default: out/<name of the case>)");
  command->add_flag("--force", options.run.force, "replace the results of an earlier run");
  command->add_option("--threads,-t", options.run.threads, "number of threads (default: all)")
      ->check(CLI::Range(0, 1024));
}

void add_resume(CLI::App& app, Options& options) {
  auto* command =
      app.add_subcommand("resume", "go on with a run that was stopped, from its last checkpoint");
  command->add_option("folder", options.resume.folder, "folder of a run")->required();
  command->add_option("--threads,-t", options.resume.threads, "number of threads (default: all)")
      ->check(CLI::Range(0, 1024));
}

void add_preview(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand(
      "preview", "show the particles, walls and gauges of a case, without a run");
  command->add_option("case", options.preview.case_file, "case file (TOML)")->required();
  command->add_option("--output,-o", options.preview.output,
                      "folder for pictures (default: out/<name of the case>-preview)");
}

void add_plot(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand("plot", "draw gauges, sums and particle frames of a run");
  command->add_option("folder", options.plot.folder, "folder of a run")->required();
  command->add_option("--field", options.plot.field, "field that colours the particles")
      ->capture_default_str();
}

void add_surface(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand(
      "surface", "write the free surface of frames of a run: triangles in 3D, lines in 2D");
  command->add_option("folder", options.surface.folder, "folder of a run")->required();
  auto* frame = command
                    ->add_option("--frame", options.surface.frame,
                                 "number of the frame, from 0 (default: the last one)")
                    ->check(CLI::NonNegativeNumber);
  command->add_flag("--all", options.surface.all, "all frames")->excludes(frame);
  command->add_option("--material", options.surface.material,
                      "particles of this material only (default: of all)");
  command
      ->add_option("--share", options.surface.share,
                   "share of the kernel that is filled with particles at the surface")
      ->check(CLI::Range(0.01, 0.99))
      ->capture_default_str();
}

void add_bench(CLI::App& app, Options& options) {
  auto* command = app.add_subcommand("bench", "measure the speed of this program on this machine");
  command->add_option("name", options.bench.names,
                      "workloads, case files, or roof (default: the usual ones)");
  command->add_flag("--list", options.bench.list, "say which workloads there are");
  command->add_flag("--json", options.bench.json, "figures as JSON");
  command->add_option("--threads,-t", options.bench.threads, "number of threads (default: all)")
      ->check(CLI::Range(0, 1024));
  command->add_option("--steps", options.bench.steps, "timed steps (default: of the workload)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--warm-up", options.bench.warm_up,
                   "steps before the clock starts (default: of the workload)")
      ->check(CLI::NonNegativeNumber);
}

void add_verify(CLI::App& app, Options& options) {
  auto* command =
      app.add_subcommand("verify", "compare this program with exact and measured results");
  command->add_option("name", options.verify.names, "checks (default: all)");
  command->add_flag("--list", options.verify.list, "say which checks there are");
  command->add_flag("--quick", options.verify.quick, "coarser and shorter, same tolerances");
  command->add_flag("--json", options.verify.json, "results as JSON");
  command->add_option("--report", options.verify.report,
                      "write the results as a page for browsers");
  command->add_option("--threads,-t", options.verify.threads, "number of threads (default: all)")
      ->check(CLI::Range(0, 1024));
}

/// CLI11 says of an unknown command only that one is missing.
void check_command(CLI::App const& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string const wanted = argv[1];
  std::vector<std::string> names;
  for (auto const* command : app.get_subcommands([](CLI::App const*) { return true; }))
    names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), wanted) != names.end()) return;
  std::vector<std::string_view> const known(names.begin(), names.end());
  throw moraine::InputErrors({{"moraine", 0, 0, "", fmt::format("\"{}\"", wanted),
                               "is not a command", moraine::name_hint(wanted, known)}});
}

int dispatch(CLI::App const& app, Options const& options) {
  if (auto const code = moraine::run_case_command(app, options.cases)) return *code;
  if (auto const code = moraine::run_blast_command(app, options.blast)) return *code;
  if (auto const code = moraine::run_motion_command(app, options.motion)) return *code;
  if (auto const code = moraine::run_point_command(app, options.point)) return *code;
  if (auto const code = moraine::run_slosh_command(app, options.slosh)) return *code;
  if (auto const code = moraine::run_report_command(app, options.report)) return *code;
  if (auto const code = moraine::run_reproduce_command(app, options.reproduce)) return *code;
  if (auto const code = moraine::run_watch_command(app, options.watch)) return *code;
  if (auto const code = moraine::run_sweep_command(app, options.sweep)) return *code;
  if (app.got_subcommand("run")) return moraine::run_case(options.run);
  if (app.got_subcommand("resume")) return moraine::resume_run(options.resume);
  if (app.got_subcommand("preview")) return moraine::preview_case(options.preview);
  if (app.got_subcommand("surface")) return moraine::draw_surfaces(options.surface);
  if (app.got_subcommand("bench")) return moraine::run_bench(options.bench);
  if (app.got_subcommand("verify")) return moraine::run_verify(options.verify);
  if (app.got_subcommand("exact")) return moraine::run_exact(options.exact);
  return moraine::plot_folder(options.plot);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files is an error of writing
  CLI::App app{
      "Moraine: particles for extreme events in civil, geotechnical and ocean engineering"};
  app.set_version_flag("--version", MORAINE_VERSION);
  app.require_subcommand(1);
  Options options;
  add_run(app, options);
  add_resume(app, options);
  add_preview(app, options);
  add_plot(app, options);
  add_surface(app, options);
  add_bench(app, options);
  add_verify(app, options);
  moraine::add_report_command(app, options.report);
  moraine::add_reproduce_command(app, options.reproduce);
  moraine::add_watch_command(app, options.watch);
  moraine::add_exact(app, options.exact);
  moraine::add_case_commands(app, options.cases);
  moraine::add_blast_command(app, options.blast);
  moraine::add_motion_command(app, options.motion);
  moraine::add_point_command(app, options.point);
  moraine::add_slosh_command(app, options.slosh);
  moraine::add_sweep_command(app, options.sweep);
  try {
    check_command(app, argc, argv);
    app.parse(argc, argv);
    return dispatch(app, options);
  } catch (CLI::ParseError const& error) {
    return app.exit(error) == 0 ? 0 : moraine::ExitCode::bad_input;
  } catch (moraine::InputErrors const& errors) {
    fmt::print(stderr, "{}\n", errors.what());
    return moraine::ExitCode::bad_input;
  } catch (moraine::OutputError const& error) {
    fmt::print(stderr, "moraine: {}\n", error.what());
    return moraine::ExitCode::not_written;
  } catch (std::exception const& error) {
    fmt::print(stderr, "moraine: {}\n", error.what());
    return moraine::ExitCode::failed;
  }
}
