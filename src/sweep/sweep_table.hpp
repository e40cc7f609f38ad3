// The results of a sweep: which values gave which numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace moraine {

/// Exactly what report/FORMAT.md calls a Sweep. Numbers are in SI units.
struct SweepTable {
  struct Heading {
    std::string label;
    std::string unit;
  };
  enum class State : std::uint8_t { done, failed, waiting };
  struct Member {
    std::string name;
    State state = State::waiting;
    std::string message;             // of failures
    std::optional<std::size_t> run;  // index among the runs of a report
    std::vector<std::variant<double, std::string>> values;
    std::vector<std::optional<double>> outputs;  // nothing where there is no number
  };
  std::string title;
  std::vector<Heading> parameters;
  std::vector<Heading> outputs;
  std::vector<Member> members;
};

/// What tables hold beside, for each member: nothing for those that are not done.
struct MemberCost {
  std::optional<double> steps;
  std::optional<double> wall_time;  // s, of the last process that ran it
};

/// "done", "failed", "waiting".
char const* state_name(SweepTable::State state);

/// One row for each member: member, state, values, outputs, steps, wall time and message; fields
/// without a number are empty. Texts are quoted as in RFC 4180. Throws OutputError.
void write_sweep_csv(SweepTable const& table, std::vector<MemberCost> const& costs,
                     std::filesystem::path const& file);

/// The table as a Sweep of report/FORMAT.md, each member with `steps` and `wall_time_s` beside.
/// Throws OutputError.
void write_sweep_json(SweepTable const& table, std::vector<MemberCost> const& costs,
                      std::filesystem::path const& file);

/// That object. Without `costs` none are told.
nlohmann::ordered_json sweep_json(SweepTable const& table, std::vector<MemberCost> const& costs);

/// Reads `sweep.json` in the folder of a sweep. Throws std::runtime_error if it is missing or
/// malformed.
SweepTable read_sweep_table(std::filesystem::path const& folder);

/// The folders of the runs of all members, in their order; those that wait may not be there.
std::vector<std::filesystem::path> member_folders(SweepTable const& table,
                                                  std::filesystem::path const& folder);

}  // namespace moraine
