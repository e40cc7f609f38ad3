#include "sweep/member_folder.hpp"

#include <fmt/core.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <vector>

#include "output/atomic_file.hpp"
#include "output/checkpoint/checkpoints.hpp"
#include "output/run_lock.hpp"
#include "output/sha256.hpp"

namespace moraine {
namespace {

using Json = nlohmann::json;

std::string bytes_of(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Null where there is no such file or it is damaged.
Json json_of(std::filesystem::path const& file) {
  Json json = Json::parse(bytes_of(file), nullptr, false);
  return json.is_object() ? json : Json();
}

std::string text_in(Json const& json, char const* key) {
  if (!json.is_object() || !json.contains(key) || !json[key].is_string()) return {};
  return json[key].get<std::string>();
}

std::filesystem::path failure_file(MemberFolder const& member) {
  return member.folder / "failure.json";
}

/// Empty while the run goes on, and after it was killed.
std::string end_reason(MemberFolder const& member) {
  Json const manifest = json_of(member.folder / "manifest.json");
  return manifest.is_object() && manifest.contains("end") ? text_in(manifest["end"], "reason") : "";
}

}  // namespace

MemberStatus status_of(MemberFolder const& member) {
  std::string const digest = sha256(member.case_text);
  Json const manifest = json_of(member.folder / "manifest.json");
  Json const failure = json_of(failure_file(member));
  if (manifest.is_null() && failure.is_null()) return {};
  bool const same_file = bytes_of(member.folder / "case.toml") == member.case_text;
  if (!failure.is_null() && text_in(failure, "case_sha256") == digest && same_file)
    return {MemberState::failed, text_in(failure, "message")};
  if (!same_file) return {MemberState::changed, ""};
  // Killed between writing the new case file and clearing the old results away.
  if (text_in(manifest, "case_sha256") != digest) return {};
  return {end_reason(member) == "end time reached" ? MemberState::done : MemberState::unfinished,
          ""};
}

bool is_running(MemberFolder const& member) { return RunLock::is_held(member.folder); }

bool can_resume(MemberFolder const& member) {
  std::vector<std::string> skipped;
  return status_of(member).state == MemberState::unfinished &&
         Checkpoints(member.folder).newest(skipped).has_value();
}

void prepare(MemberFolder const& member) {
  AtomicFile file(member.folder / "case.toml");
  file.stream() << member.case_text;
  file.commit();
  remove_file(failure_file(member));
}

void note_failure(MemberFolder const& member, int exit_code, std::string const& message) {
  nlohmann::ordered_json const json{
      {"case_sha256", sha256(member.case_text)}, {"exit_code", exit_code}, {"message", message}};
  AtomicFile file(failure_file(member));
  file.stream() << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  file.commit();
}

std::string reason_of_failure(MemberFolder const& member, std::uintmax_t log_start) {
  std::string const reason = end_reason(member);
  if (!reason.empty() && reason != "end time reached" && reason != "interrupted")
    return reason.substr(0, reason.find('\n'));
  std::string text = bytes_of(log_of(member));
  text.erase(0, std::min<std::size_t>(static_cast<std::size_t>(log_start), text.size()));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  auto const line = text.rfind('\n');
  return line == std::string::npos ? text : text.substr(line + 1);
}

std::filesystem::path log_of(MemberFolder const& member) { return member.folder / "log.txt"; }

}  // namespace moraine
