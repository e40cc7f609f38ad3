// From the folders of members to the table of a sweep.
#pragma once

#include <vector>

#include "sweep/member_folder.hpp"
#include "sweep/sweep_plan.hpp"
#include "sweep/sweep_table.hpp"

namespace moraine {

/// The table of a sweep while its members come to their ends.
class SweepResults {
 public:
  explicit SweepResults(SweepPlan const& plan);

  /// Takes what has become of a member; reads its outputs if it is done.
  void take(std::size_t member, MemberFolder const& place, MemberStatus const& status);

  SweepTable const& table() const { return table_; }
  std::vector<MemberCost> const& costs() const { return costs_; }
  std::size_t count(SweepTable::State state) const;

  /// Writes `sweep.csv` and `sweep.json`. Throws OutputError.
  void write(std::filesystem::path const& folder) const;

  /// The table for people: members below one another, the parameters that vary, SI numbers
  /// to five digits.
  std::string text() const;

 private:
  SweepPlan const& plan_;
  SweepTable table_;
  std::vector<MemberCost> costs_;
};

}  // namespace moraine
