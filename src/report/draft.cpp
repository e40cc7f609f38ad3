#include "report/draft.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "report/curves.hpp"
#include "report/page.hpp"
#include "report/run_json.hpp"

namespace moraine::report {
namespace {

constexpr std::size_t words_around = 2000;   // bytes: titles, and a note on runs that are left out
constexpr std::size_t words_of_run = 600;    // bytes: notes on what is left out
constexpr std::size_t least_curves = 4'000;  // bytes: a few columns of some hundred rows

std::size_t room_of(std::size_t most, std::size_t taken) { return most > taken ? most - taken : 0; }

/// A run as it goes into a draft.
struct Piece {
  Json json;
  Blocks blocks;
  std::size_t size() const { return bytes_in_page(json) + blocks.size(); }
};

/// What a run may take: its share, all that is left, and for its settings.
struct Offer {
  std::size_t share, room, settings;
};

Piece piece_of(RunFiles& run, Offer const& offer) {
  Piece piece;
  piece.json = run_head(run, piece.blocks);
  std::size_t const told = run.notes.size();
  if (piece.blocks.size() > offer.share / 4) {
    piece.blocks = Blocks();
    piece.json["references"] = Json::array();
    run.notes.push_back("curves of references are left out of this page");
  }
  if (piece.size() > offer.settings && !piece.json["settings"].empty()) {
    piece.json["settings"] = Json::array();
    run.notes.push_back("settings are left out of this page; case.used.toml has them");
  }
  std::size_t const taken = piece.size() + words_of_run;
  std::size_t const most = std::max(offer.share, std::min(offer.room, taken + least_curves));
  Curves curves = curves_of(run, room_of(most, taken));
  piece.json["tables"] = std::move(curves.tables);
  piece.blocks.add(std::move(curves.blocks));
  run.notes.insert(run.notes.end(), curves.notes.begin(), curves.notes.end());
  add_later_notes(piece.json, run, told);
  return piece;
}

/// Names of runs are told apart; numbers name their blocks.
class RunReader {
 public:
  RunFiles read(std::filesystem::path const& folder, std::size_t number) {
    RunFiles run = read_run_files(folder);
    std::string const plain = run.name;
    for (int copy = 2; !names_.insert(run.name).second; ++copy)
      run.name = fmt::format("{} ({})", plain, copy);
    run.prefix = fmt::format("run-{}", number);
    return run;
  }

 private:
  std::set<std::string> names_;
};

/// Runs of one title, as those of one case at several spacings, go by the names of their folders.
void tell_apart(Json& runs) {
  std::map<std::string, int> count;
  for (auto const& run : runs) ++count[run["title"].get<std::string>()];
  for (auto& run : runs)
    if (count[run["title"].get<std::string>()] > 1) run["title"] = run["name"];
}

/// What is said where only the first of `all` runs have found room.
void tell_left_out(Draft& draft, std::size_t all) {
  std::size_t const kept = draft.runs.size();
  if (kept == all) return;
  RunFiles& first = draft.runs.front();
  first.notes.push_back(fmt::format(
      "{} of {} runs are left out of this page, which would be too large; moraine report with one "
      "of their folders shows it",
      all - kept, all));
  add_later_notes(draft.json["runs"][0], first, first.notes.size() - 1);
  if (draft.json["sweep"].is_null()) return;
  for (auto& member : draft.json["sweep"]["members"])
    if (member["run"].is_number() && member["run"].get<std::size_t>() >= kept)
      member["run"] = nullptr;
}

}  // namespace

std::size_t Draft::size() const { return bytes_in_page(json) + blocks.size(); }

Draft without_particles(std::vector<std::filesystem::path> const& folders, Json sweep,
                        std::size_t bytes) {
  Draft draft;
  draft.json = empty_report();
  draft.json["sweep"] = std::move(sweep);
  std::size_t room = room_of(bytes, draft.size() + words_around);
  RunReader reader;
  for (auto const& folder : folders) {
    std::size_t const number = draft.runs.size();
    RunFiles run = reader.read(folder, number);
    std::size_t const share = room / (folders.size() - number);
    // Members of a sweep differ in few settings: those of the first are told in any case.
    Piece piece = piece_of(run, {share, room, (number == 0 ? room : share) / 2});
    std::size_t const size = piece.size() + run.name.size();  // which may become its title
    if (number > 0 && size > room) break;
    room = room_of(room, size);
    draft.json["runs"].push_back(std::move(piece.json));
    draft.blocks.add(std::move(piece.blocks));
    run.gauges = run.sums = Table();
    draft.runs.push_back(std::move(run));
  }
  tell_apart(draft.json["runs"]);
  tell_left_out(draft, folders.size());
  return draft;
}

}  // namespace moraine::report
