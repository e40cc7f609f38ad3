#include "app/watch_command.hpp"

#include <fmt/core.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "report/run_files.hpp"
#include "watch/live_server.hpp"
#include "watch/screen.hpp"

namespace moraine {
namespace {

using Clock = std::chrono::steady_clock;

/// Ctrl-C and SIGTERM as something to wait for, also for threads that are busy.
class EndSignal {
 public:
  EndSignal() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGINT);
    sigaddset(&set_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &set_, nullptr);  // threads made from here on inherit it
  }
  void wait() const {
    int which = 0;
    sigwait(&set_, &which);
  }
  /// True if it came within this time.
  bool came_within(std::chrono::nanoseconds time) const {
    auto const whole = std::chrono::duration_cast<std::chrono::seconds>(time);
    timespec const limit{whole.count(), static_cast<long>((time - whole).count())};
    return sigtimedwait(&set_, nullptr, &limit) > 0;
  }

 private:
  sigset_t set_{};
};

watch::ScreenSize terminal_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {};
  return {size.ws_col, size.ws_row};
}

/// Draws the screen every second until the run ends. Long tables take time to read: at most a tenth
/// of the time is spent on them.
int watch_in_terminal(WatchOptions const& options) {
  EndSignal const end;
  bool const terminal = isatty(STDOUT_FILENO) != 0;
  for (;;) {
    auto const start = Clock::now();
    auto const run = report::read_run_files(options.folder);
    if (terminal && !options.once) fmt::print("\x1b[H\x1b[2J");
    fmt::print("{}",
               watch::screen_of(run, terminal ? terminal_size() : watch::ScreenSize{100, 60}));
    std::fflush(stdout);
    if (options.once || !terminal || state_of(run) != "running") return ExitCode::done;
    std::chrono::nanoseconds const pause =
        std::max<std::chrono::nanoseconds>(std::chrono::seconds(1), 9 * (Clock::now() - start));
    if (end.came_within(pause)) return ExitCode::interrupted;
  }
}

int watch_in_browser(WatchOptions const& options) {
  report::read_run_files(options.folder);  // refuses what is no run
  EndSignal const end;
  watch::LiveServer server(std::filesystem::canonical(options.folder));
  int port = 0;
  try {
    port = server.bind(options.port);
  } catch (std::runtime_error const& error) {
    throw InputErrors({{"moraine watch", 0, 0, "--port", std::to_string(options.port), error.what(),
                        "leave it out: any free port is taken"}});
  }
  fmt::print("http://127.0.0.1:{}/  (for this machine only; Ctrl-C ends it)\n", port);
  std::fflush(stdout);
  std::thread serving([&server] { server.serve(); });
  end.wait();
  server.stop();
  serving.join();
  return ExitCode::done;
}

}  // namespace

void add_watch_command(CLI::App& app, WatchOptions& options) {
  auto* command = app.add_subcommand("watch", "look on while a run goes on, here or in a browser");
  command->add_option("folder", options.folder, "folder of a run")->required();
  command->add_flag("--once", options.once, "show it once");
  auto* web = command->add_flag("--web", options.web,
                                "serve the page of the run to browsers on this machine, read only");
  command->add_option("--port", options.port, "port of the page (default: any that is free)")
      ->check(CLI::Range(0, 65535))
      ->needs(web);
  command->footer(
      "Examples:\n"
      "  moraine watch out/tnt-in-water\n"
      "  moraine watch out/tnt-in-water --web --port 8080\n"
      "A run looks for files in its folder: \"snapshot\" makes it write its particles as they "
      "are,\n"
      "\"stop\" makes it save its state and stop. status.json tells programs how far it is.");
}

std::optional<int> run_watch_command(CLI::App const& app, WatchOptions const& options) {
  if (!app.got_subcommand("watch")) return std::nullopt;
  return options.web ? watch_in_browser(options) : watch_in_terminal(options);
}

}  // namespace moraine
