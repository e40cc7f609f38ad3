#include "report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "output/atomic_file.hpp"
#include "report/page.hpp"
#include "report/particles.hpp"
#include "report/run_files.hpp"
#include "report/run_json.hpp"

namespace moraine::report {
namespace {

constexpr std::size_t most_rows = 4000;  // a line on a large screen has no more points
constexpr std::size_t fewest_rows = 100;

std::vector<RunFiles> read_runs(std::vector<std::filesystem::path> const& folders) {
  std::vector<RunFiles> runs;
  std::set<std::string> names;
  for (auto const& folder : folders) {
    RunFiles run = read_run_files(folder);
    std::string const plain = run.name;
    for (int copy = 2; !names.insert(run.name).second; ++copy)
      run.name = fmt::format("{} ({})", plain, copy);
    run.prefix = fmt::format("run-{}", runs.size());
    runs.push_back(std::move(run));
  }
  return runs;
}

/// A report while it is put together.
struct Draft {
  Json json = empty_report();
  Blocks blocks;
  std::size_t size() const {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace).size() + blocks.size();
  }
};

/// Runs of one title, as those of one case at several spacings, go by the names of their folders.
void tell_apart(Json& runs) {
  std::map<std::string, int> count;
  for (auto const& run : runs) ++count[run["title"].get<std::string>()];
  for (auto& run : runs)
    if (count[run["title"].get<std::string>()] > 1) run["title"] = run["name"];
}

/// All but particles, with as many rows of tables as fit into `bytes`.
Draft without_particles(std::vector<RunFiles>& runs, std::size_t bytes) {
  for (std::size_t rows = most_rows;; rows = rows * 2 / 3) {
    Draft draft;
    for (RunFiles& run : runs) {
      auto const kept = run.notes;
      draft.json["runs"].push_back(run_json(run, rows, draft.blocks));
      run.notes = kept;  // the next try finds them again
    }
    tell_apart(draft.json["runs"]);
    if (draft.size() <= bytes || rows < fewest_rows) return draft;
  }
}

/// Adds particles of `raw` bytes in all, before compression; returns whether there are any.
bool add_particles(Draft& draft, std::vector<RunFiles>& runs, ParticleBudget budget) {
  budget.bytes /= runs.size();
  bool any = false;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto& place = draft.json["runs"][i]["particles"];
    place = particles_of(runs[i], budget, draft.blocks);
    any = any || !place.is_null();
  }
  return any;
}

void drop_particles(Draft& draft, std::vector<RunFiles> const& runs) {
  for (RunFiles const& run : runs)
    for (char const* const part : {"/frame-", "/walls-"}) draft.blocks.drop(run.prefix + part);
}

/// Fills the room that is left: quantised numbers shrink by a part that nobody knows beforehand.
bool fill_with_particles(Draft& draft, std::vector<RunFiles>& runs, std::size_t room) {
  std::size_t const before = draft.size();
  ParticleBudget budget;
  budget.bytes = room;
  for (int tries = 0; tries < 8; ++tries) {
    if (!add_particles(draft, runs, budget)) return false;
    std::size_t const used = draft.size() - before;
    if (used <= room) return true;
    drop_particles(draft, runs);
    budget.bytes = static_cast<std::size_t>(0.9 * static_cast<double>(budget.bytes) *
                                            static_cast<double>(room) / static_cast<double>(used));
  }
  for (auto& run : draft.json["runs"]) run["particles"] = nullptr;
  return false;
}

std::size_t room_of(std::size_t most, std::size_t taken) { return most > taken ? most - taken : 0; }

std::string title_of(ReportOptions const& options, Draft const& draft) {
  if (!options.title.empty()) return options.title;
  auto const& runs = draft.json["runs"];
  return runs.size() == 1 ? runs[0]["title"].get<std::string>()
                          : fmt::format("{} runs of Moraine", runs.size());
}

}  // namespace

void write_report(std::vector<std::filesystem::path> const& folders, ReportOptions const& options) {
  std::vector<RunFiles> runs = read_runs(folders);
  Draft draft =
      without_particles(runs, room_of(options.most_bytes_without_particles, page_size(false)));
  draft.json["sweep"] = options.sweep;
  bool const player =
      fill_with_particles(draft, runs, room_of(options.most_bytes, page_size(true) + draft.size()));
  AtomicFile file(options.file);
  file.stream() << page_of(title_of(options, draft), draft.json, draft.blocks, player);
  file.commit();
}

Json live_data(std::filesystem::path const& folder) {
  std::vector<RunFiles> runs = read_runs({folder});
  Draft draft = without_particles(runs, 600'000);
  fill_with_particles(draft, runs, 3'000'000);
  draft.json["blocks"] = draft.blocks.object();
  return draft.json;
}

std::string live_page(std::string const& title, double interval) {
  Json report = empty_report();
  report["live"] = {{"data", "data.json"}, {"interval_s", interval}};
  return page_of(title, report, Blocks(), true);
}

}  // namespace moraine::report
