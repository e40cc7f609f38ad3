// moraine report: the page of one or several runs.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moraine {

struct ReportCommandOptions {
  std::vector<std::string> folders;
  std::string output;  // empty: report.html in the folder, or here for several
  std::string title;
};

void add_report_command(CLI::App& app, ReportCommandOptions& options);

/// The exit code, or nothing where the command line asks for another command.
std::optional<int> run_report_command(CLI::App const& app, ReportCommandOptions const& options);

}  // namespace moraine
