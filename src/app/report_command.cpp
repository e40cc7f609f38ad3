#include "app/report_command.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands.hpp"
#include "report/report.hpp"
#include "sweep/sweep_page.hpp"

namespace moraine {

void add_report_command(CLI::App& app, ReportCommandOptions& options) {
  auto* command = app.add_subcommand(
      "report",
      "write the page of a run or a sweep, or one that draws several runs over each other");
  command->add_option("folders", options.folders, "folders of runs, or that of a sweep")
      ->required();
  command->add_option("--output,-o", options.output,
                      "file to write (default: report.html in the folder; of several runs, here)");
  command->add_option("--title", options.title,
                      "title of the page (default: that of the run or sweep)");
  command->footer(
      "Examples:\n"
      "  moraine report out/tnt-in-water\n"
      "  moraine report out/coarse out/fine --output spacing.html --title \"Two spacings\"");
}

std::optional<int> run_report_command(CLI::App const& app, ReportCommandOptions const& options) {
  if (!app.got_subcommand("report")) return std::nullopt;
  std::vector<std::filesystem::path> const folders(options.folders.begin(), options.folders.end());
  if (folders.size() == 1 && holds_a_sweep(folders.front())) {
    std::filesystem::path page = options.output;
    if (page.empty()) page = folders.front() / "sweep.html";
    write_sweep_page(folders.front(), page, options.title);
    fmt::print("{}\n", page.string());
    return ExitCode::done;
  }
  report::ReportOptions report{.file = options.output, .title = options.title};
  if (report.file.empty())
    report.file = folders.size() == 1 ? folders.front() / "report.html" : "report.html";
  report::write_report(folders, report);
  fmt::print("{}\n", report.file.string());
  return ExitCode::done;
}

}  // namespace moraine
