// The folder of a member: its case, its run, and what has become of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace moraine {

/// A member that is to run in a folder of its own, `case` being the text of its case file.
struct MemberFolder {
  std::string name;
  std::filesystem::path folder;
  std::string case_text;
};

/// `none`: no results. `unfinished`: a run that was stopped or killed. `changed`: results of
/// another case.
enum class MemberState : std::uint8_t { none, unfinished, done, failed, changed };

struct MemberStatus {
  MemberState state = MemberState::none;
  std::string message;  // of failures
};

/// What the folder of a member holds. Results belong to a member when the digest of its case is
/// that of the case file which the run read.
MemberStatus status_of(MemberFolder const& member);

/// Whether another process still runs there.
bool is_running(MemberFolder const& member);

/// Whether a run there can go on from a checkpoint.
bool can_resume(MemberFolder const& member);

/// Writes the case file, and forgets a failure. Throws OutputError.
void prepare(MemberFolder const& member);

/// Notes that the member failed for good, so that it is not tried again. Throws OutputError.
void note_failure(MemberFolder const& member, int exit_code, std::string const& message);

/// Why a run ended without reaching its end: from its manifest (first line), or the last line of
/// its log from this byte on.
std::string reason_of_failure(MemberFolder const& member, std::uintmax_t log_start);

std::filesystem::path log_of(MemberFolder const& member);

}  // namespace moraine
