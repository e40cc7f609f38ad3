#include "app/sweep_command.hpp"

#include <fmt/core.h>
#include <omp.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <thread>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "base/input_error.hpp"
#include "output/atomic_file.hpp"
#include "output/output_error.hpp"
#include "output/run_folder.hpp"
#include "output/run_lock.hpp"
#include "sweep/read_sweep.hpp"
#include "sweep/run_members.hpp"
#include "sweep/sweep_folder.hpp"
#include "sweep/sweep_page.hpp"
#include "sweep/sweep_plots.hpp"
#include "sweep/sweep_results.hpp"

namespace moraine {
namespace {

constexpr char const* examples =
    R"(The sweep file names a case, the keys that change, their values, and what is taken from each run;
docs/sweeps.md describes it. Results go to FOLDER: sweep.html (the members beside each other),
sweep.csv, sweep.json, pictures in plots/, and a folder with a run for each member. The same command goes on after a stop: members that are done are
kept, others go on from their checkpoints.

Examples:
  moraine sweep cases/tnt-in-water/sweeps/kernels.toml --list
  moraine sweep cases/tnt-in-water/sweeps/kernels.toml
  moraine sweep cases/tnt-in-water/sweeps/kernels.toml --output out/kernels --at-once 2 --threads 2
  moraine sweep cases/tnt-in-water/sweeps/kernels.toml --force
)";

// A sweep that was killed has told its members to stop; they save their state first.
constexpr std::chrono::seconds longest_wait(120);

[[noreturn]] void refuse(std::filesystem::path const& folder, std::string rule, std::string hint) {
  throw InputErrors({{"moraine sweep", 0, 0, "--output", fmt::format("\"{}\"", folder.string()),
                      std::move(rule), std::move(hint)}});
}

void check_output(std::filesystem::path const& folder) {
  constexpr char const* another = "choose another folder with --output";
  std::filesystem::path place = std::filesystem::absolute(folder);
  while (!std::filesystem::exists(place) && place.has_relative_path()) place = place.parent_path();
  if (!std::filesystem::is_directory(place))
    refuse(folder, fmt::format("cannot be a folder: \"{}\" is a file", place.string()), another);
  if (access(place.c_str(), W_OK | X_OK) != 0)
    refuse(folder, fmt::format("cannot be written: {}", std::strerror(errno)), another);
  if (holds_a_run(folder)) refuse(folder, "holds the results of a run", another);
  if (RunLock::is_held(folder))
    refuse(folder, "belongs to a sweep that is still going on", another);
}

void wait_for_members(std::vector<MemberFolder> const& members) {
  auto const start = std::chrono::steady_clock::now();
  bool said = false;
  for (MemberFolder const& member : members)
    while (is_running(member)) {
      if (!std::exchange(said, true))
        fmt::print(stderr, "waits for members that are still being stopped\n");
      if (std::chrono::steady_clock::now() - start > longest_wait)
        refuse(member.folder, "belongs to a run that is still going on",
               "wait for its end, or stop it");
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

/// Results of another case are not overwritten unasked.
void check_changed(std::string const& file, std::vector<MemberFolder> const& members) {
  std::vector<InputProblem> problems;
  for (MemberFolder const& member : members)
    if (status_of(member).state == MemberState::changed)
      problems.push_back({file, 0, 0, member.name, "",
                          fmt::format("has changed: \"{}\" holds the results of another case",
                                      member.folder.string()),
                          "--force replaces them, --output takes another folder"});
  if (!problems.empty()) throw InputErrors(std::move(problems));
}

RunLock locked(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw OutputError(
        fmt::format("cannot make the folder '{}': {}", folder.string(), error.message()));
  auto lock = RunLock::take(folder);
  if (!lock) refuse(folder, "belongs to a sweep that is still going on", "");
  return std::move(*lock);
}

char const* word_for(MemberState state) {
  switch (state) {
    case MemberState::none:
      return "to run";
    case MemberState::unfinished:
      return "to go on";
    case MemberState::done:
      return "done";
    case MemberState::failed:
      return "failed";
    case MemberState::changed:
      return "changed";
  }
  return "";
}

void list_members(SweepPlan const& plan, std::vector<MemberFolder> const& members) {
  auto const columns = plan.columns();
  for (std::size_t i = 0; i < members.size(); ++i) {
    fmt::print("{}: {}\n", members[i].name, word_for(status_of(members[i]).state));
    for (std::size_t c = 0; c < columns.size(); ++c)
      fmt::print("  {} = {}\n", columns[c].key.path, plan.members[i].values[c].toml);
  }
  fmt::print("{} member{}\n", members.size(), members.size() == 1 ? "" : "s");
}

class SweepRun {
 public:
  SweepRun(Sweep const& sweep, std::vector<MemberFolder> const& members,
           std::filesystem::path folder, SweepOptions const& options)
      : plan_(sweep.plan),
        members_(members),
        folder_(std::move(folder)),
        options_(options),
        results_(sweep.plan) {}

  int run() {
    std::vector<std::size_t> const wanted = look();
    say_start(wanted.size());
    results_.write(folder_);
    bool const all = run_members(members_, wanted, settings(wanted.size()), counts(), progress_,
                                 [this](std::size_t member, MemberStatus const& status) {
                                   results_.take(member, members_[member], status);
                                   results_.write(folder_);
                                 });
    return say_end(all);
  }

 private:
  /// Takes the results that there are; returns the members that are to run.
  std::vector<std::size_t> look() {
    std::vector<std::size_t> wanted;
    for (std::size_t i = 0; i < members_.size(); ++i) {
      MemberStatus const status = status_of(members_[i]);
      bool const kept = status.state == MemberState::done ||
                        (status.state == MemberState::failed && !options_.force);
      if (kept)
        results_.take(i, members_[i], status);
      else
        wanted.push_back(i);
    }
    return wanted;
  }

  RunSettings settings(std::size_t wanted) const {
    auto const lanes =
        static_cast<std::size_t>(options_.at_once > 0 ? options_.at_once : plan_.at_once);
    return {std::max<std::size_t>(1, std::min(lanes, wanted)),
            options_.threads > 0 ? options_.threads : omp_get_max_threads()};
  }

  SweepCount counts() const {
    return {members_.size(),
            results_.count(SweepTable::State::done),
            results_.count(SweepTable::State::failed),
            {},
            1};
  }

  void say_start(std::size_t wanted) {
    auto const kept = members_.size() - wanted;
    fmt::print("{}\n{} member{} of {}", plan_.title, members_.size(),
               members_.size() == 1 ? "" : "s", plan_.case_file.string());
    if (kept > 0) fmt::print(", {} kept from before", kept);
    if (wanted == 0) fmt::print(": nothing is left to run");
    fmt::print("\n");
    std::fflush(stdout);
  }

  int say_end(bool all) {
    fmt::print("\n{}", results_.text());
    for (auto const& member : results_.table().members)
      if (member.state == SweepTable::State::failed)
        fmt::print("{} failed: {}\n", member.name, member.message);
    for (std::string const& name : strangers(members_, folder_))
      fmt::print("members/{} belongs to no member of this sweep; it is left as it is\n", name);
    fmt::print("results in {}: sweep.csv, sweep.json, members/\n", folder_.string());
    for (auto const& file : plot_sweep(plan_, results_.table(), folder_ / "plots"))
      fmt::print("{}\n", file.string());
    if (!all) fmt::print("stopped; the same command goes on\n");
    std::fflush(stdout);  // the page of many members takes a while
    write_page();
    if (!all) return ExitCode::interrupted;
    return results_.count(SweepTable::State::done) == members_.size() ? ExitCode::done
                                                                      : ExitCode::failed;
  }

  /// The results are whole without their page: what goes wrong with it is told, and ends nothing.
  void write_page() const {
    auto const page = folder_ / "sweep.html";
    try {
      write_sweep_page(folder_, page);
      fmt::print("{} (any browser)\n", page.string());
    } catch (std::exception const& error) {
      fmt::print(stderr,
                 "warning: {} could not be written: {}\nall other results are there; to try again: "
                 "moraine report {}\n",
                 page.string(), error.what(), folder_.string());
    }
  }

  SweepPlan const& plan_;
  std::vector<MemberFolder> const& members_;
  std::filesystem::path folder_;
  SweepOptions const& options_;
  SweepResults results_;
  SweepProgress progress_;
};

int sweep_case(SweepOptions const& options) {
  Sweep const sweep = read_sweep(options.file);
  std::filesystem::path const folder = options.output.empty()
                                           ? "out" / std::filesystem::path(options.file).stem()
                                           : std::filesystem::path(options.output);
  auto const members = member_places(sweep, folder);
  if (options.list) {
    list_members(sweep.plan, members);
    return ExitCode::done;
  }
  check_output(folder);
  wait_for_members(members);
  if (!options.force) check_changed(options.file, members);
  RunLock const lock = locked(folder);
  remove_temporaries(folder);
  for (std::string const& line : adopt_renumbered(members, folder)) fmt::print("{}\n", line);
  return SweepRun(sweep, members, folder, options).run();
}

}  // namespace

void add_sweep_command(CLI::App& app, SweepOptions& options) {
  auto* command = app.add_subcommand(
      "sweep", "run a case many times with other values, and compare the results");
  command->add_option("file", options.file, "sweep file (TOML)")->required();
  command->add_option("--output,-o", options.output,
                      "folder for results (default: out/<name of the sweep file>)");
  command
      ->add_option("--at-once", options.at_once,
                   "members that run at the same time (default: as the file says, else 1)")
      ->check(CLI::Range(1, 1024));
  command
      ->add_option("--threads,-t", options.threads, "threads that the members share (default: all)")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--list", options.list, "say which members there are; run and write nothing");
  command->add_flag("--force", options.force,
                    "replace results of members that have changed, and run failed ones again");
  command->footer(examples);
}

std::optional<int> run_sweep_command(CLI::App const& app, SweepOptions const& options) {
  if (!app.got_subcommand("sweep")) return std::nullopt;
  return sweep_case(options);
}

}  // namespace moraine
