#include "report/run_files.hpp"

#include <fmt/core.h>

#include <exception>
#include <fstream>

#include "base/input_error.hpp"
#include "output/run_folder.hpp"
#include "output/run_lock.hpp"
#include "setup/read_case.hpp"

namespace moraine::report {
namespace {

/// Reads a piece where its file is there; a file that cannot be read becomes a note.
template <class Read>
void read_piece(RunFiles& run, char const* name, Read const& read) {
  auto const file = run.folder / name;
  if (!std::filesystem::exists(file)) return;
  try {
    read(file);
  } catch (std::exception const& error) {
    run.notes.push_back(fmt::format("{} is left out: {}", name, error.what()));
  }
}

nlohmann::json read_object(std::filesystem::path const& file) {
  std::ifstream stream(file);
  auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object()) throw std::runtime_error("it is no JSON object");
  return json;
}

[[noreturn]] void refuse(std::filesystem::path const& folder, std::string rule) {
  throw InputErrors({{"moraine report", 0, 0, "folder", fmt::format("\"{}\"", folder.string()),
                      std::move(rule), "give folders that \"moraine run\" has written"}});
}

std::string name_of(std::filesystem::path const& folder) {
  auto const path = std::filesystem::weakly_canonical(folder);
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

}  // namespace

RunFiles read_run_files(std::filesystem::path const& folder) {
  if (!std::filesystem::is_directory(folder))
    refuse(folder, std::filesystem::exists(folder) ? "is no run folder but a file"
                                                   : "is no run folder: it does not exist");
  if (!holds_a_run(folder)) refuse(folder, "holds no run: there is no manifest.json");
  RunFiles run;
  run.folder = folder;
  run.name = name_of(folder);
  run.going_on = RunLock::is_held(folder);
  auto const object = [](nlohmann::json& into) {
    return [&into](std::filesystem::path const& file) { into = read_object(file); };
  };
  read_piece(run, "manifest.json", object(run.manifest));
  read_piece(run, "status.json", object(run.status));
  read_piece(run, "gauges.json", object(run.gauge_summary));
  read_piece(run, "case.used.toml", [&](auto const& file) { run.used_case = read_case(file); });
  read_piece(run, "gauges.csv", [&](auto const& file) { run.gauges = read_table_csv(file); });
  read_piece(run, "sums.csv", [&](auto const& file) { run.sums = read_table_csv(file); });
  read_piece(run, "particles.pvd", [&](auto const& file) { run.frames = read_pvd(file); });
  read_piece(run, "walls.pvd", [&](auto const& file) { run.wall_frames = read_pvd(file); });
  return run;
}

std::string_view state_of(RunFiles const& run) {
  std::string const state = text_at(run.status, "state");
  for (std::string_view const end : {"ended", "stopped", "broken"})
    if (state == end) return end;
  // A status that could not be written is told from the manifest, which is there before the page.
  auto const end = run.manifest.find("end");
  if (end != run.manifest.end() && text_at(*end, "reason") == "end time reached") return "ended";
  return run.going_on ? "running" : "stopped";  // the latter also where it was killed: it can go on
}

std::string end_reason(RunFiles const& run) {
  std::string reason = text_at(run.status, "reason");
  if (reason.empty() && run.manifest.contains("end"))
    reason = text_at(run.manifest["end"], "reason");
  return reason;
}

std::optional<double> number_at(nlohmann::json const& object, char const* key) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_number()) return {};
  return object[key].get<double>();
}

std::string text_at(nlohmann::json const& object, char const* key) {
  if (!object.is_object() || !object.contains(key) || !object[key].is_string()) return {};
  return object[key].get<std::string>();
}

}  // namespace moraine::report
