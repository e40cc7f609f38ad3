#include "sweep/sweep_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <system_error>

#include "output/sha256.hpp"

namespace moraine {
namespace {

std::string bytes_of(std::filesystem::path const& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::vector<MemberFolder> member_places(Sweep const& sweep, std::filesystem::path const& folder) {
  std::vector<MemberFolder> places;
  for (SweepMember const& member : sweep.plan.members) {
    auto const place = folder / "members" / member.name;
    auto const replacements = replacements_of(sweep.plan, member);
    places.push_back({member.name, place, sweep.cases.text(replacements, place)});
  }
  return places;
}

std::vector<std::string> strangers(std::vector<MemberFolder> const& members,
                                   std::filesystem::path const& folder) {
  std::set<std::string> known;
  for (MemberFolder const& member : members) known.insert(member.name);
  std::vector<std::string> names;
  std::error_code none;
  for (auto const& entry : std::filesystem::directory_iterator(folder / "members", none))
    if (entry.is_directory(none) && !known.contains(entry.path().filename().string()))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> adopt_renumbered(std::vector<MemberFolder> const& members,
                                          std::filesystem::path const& folder) {
  std::map<std::string, std::filesystem::path> by_digest;
  for (std::string const& name : strangers(members, folder)) {
    auto const place = folder / "members" / name;
    by_digest[sha256(bytes_of(place / "case.toml"))] = place;
  }
  std::vector<std::string> lines;
  for (MemberFolder const& member : members) {
    auto const found = by_digest.find(sha256(member.case_text));
    if (found == by_digest.end() || std::filesystem::exists(member.folder)) continue;
    std::error_code failed;
    std::filesystem::rename(found->second, member.folder, failed);
    if (failed) continue;  // it runs anew
    lines.push_back(fmt::format("{} is now {}", found->second.filename().string(), member.name));
    by_digest.erase(found);
  }
  return lines;
}

}  // namespace moraine
