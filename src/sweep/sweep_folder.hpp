// The folder of a sweep: members, tables, pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sweep/member_folder.hpp"
#include "sweep/read_sweep.hpp"

namespace moraine {

/// All members with their folders below `folder/members` and the texts of their cases. Throws
/// std::runtime_error if a file that the case names cannot be read.
std::vector<MemberFolder> member_places(Sweep const& sweep, std::filesystem::path const& folder);

/// Renames folders of members that have another number now, after lines were added to or taken from
/// the sweep file: their case is the same to the byte. Returns a line for each.
std::vector<std::string> adopt_renumbered(std::vector<MemberFolder> const& members,
                                          std::filesystem::path const& folder);

/// Names of folders of members that this sweep has no more.
std::vector<std::string> strangers(std::vector<MemberFolder> const& members,
                                   std::filesystem::path const& folder);

}  // namespace moraine
