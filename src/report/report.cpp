#include "report/report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "output/atomic_file.hpp"
#include "report/draft.hpp"
#include "report/page.hpp"
#include "report/particles.hpp"
#include "report/run_json.hpp"

namespace moraine::report {
namespace {

constexpr std::size_t least_particles = 100'000;  // bytes: with less, nothing moves on the screen

/// What has been read of a run; its place in the draft stays null where there is nothing.
struct RunParticles {
  std::size_t run;
  ShownFrames frames;
};

/// Particles of the first runs, each with enough room to be worth reading.
std::vector<RunParticles> read_particles(Draft& draft, std::size_t room) {
  std::vector<RunParticles> all;
  std::size_t const runs = std::min(draft.runs.size(), room / least_particles);
  for (std::size_t i = 0; i < runs; ++i)
    if (auto frames = frames_for_page(draft.runs[i], {.bytes = room / runs}))
      all.push_back({i, std::move(*frames)});
  return all;
}

void add_particles(Draft& draft, std::vector<RunParticles> const& all) {
  for (RunParticles const& each : all)
    draft.json["runs"][each.run]["particles"] =
        particles_of(draft.runs[each.run], each.frames, draft.blocks);
}

void drop_particles(Draft& draft, std::vector<RunParticles> const& all) {
  for (RunParticles const& each : all) {
    draft.json["runs"][each.run]["particles"] = nullptr;
    for (char const* const part : {"/frame-", "/walls-"})
      draft.blocks.drop(draft.runs[each.run].prefix + part);
  }
}

/// Fills the room that is left: quantised numbers shrink by a part that nobody knows beforehand.
/// Files are read once; what does not fit is thinned further.
bool fill_with_particles(Draft& draft, std::size_t room) {
  std::vector<std::size_t> told;
  for (RunFiles const& run : draft.runs) told.push_back(run.notes.size());
  std::vector<RunParticles> all = read_particles(draft, room);
  for (std::size_t i = 0; i < draft.runs.size(); ++i)
    add_later_notes(draft.json["runs"][i], draft.runs[i], told[i]);
  std::size_t const before = draft.size();
  for (auto bytes = static_cast<double>(room); !all.empty() && bytes > 1.0;) {
    add_particles(draft, all);
    std::size_t const used = draft.size() - before;
    if (used <= room) return true;
    drop_particles(draft, all);
    bytes *= std::min(0.9, 0.9 * static_cast<double>(room) / static_cast<double>(used));
    auto const each = static_cast<std::size_t>(bytes / static_cast<double>(all.size()));
    for (RunParticles& particles : all)
      particles.frames = thinned(std::move(particles.frames), {.bytes = each});
  }
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
  Draft draft = without_particles(folders, options.sweep,
                                  room_of(options.most_bytes_without_particles, page_size(false)));
  bool const player =
      fill_with_particles(draft, room_of(options.most_bytes, page_size(true) + draft.size()));
  AtomicFile file(options.file);
  file.stream() << page_of(title_of(options, draft), draft.json, draft.blocks, player);
  file.commit();
}

Json live_data(std::filesystem::path const& folder) {
  Draft draft = without_particles({folder}, nullptr, 600'000);
  fill_with_particles(draft, 3'000'000);
  draft.json["blocks"] = draft.blocks.object();
  return draft.json;
}

std::string live_page(std::string const& title, double interval) {
  Json report = empty_report();
  report["live"] = {{"data", "data.json"}, {"interval_s", interval}};
  return page_of(title, report, Blocks(), true);
}

}  // namespace moraine::report
