#include "sweep/check_members.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

#include "output/checkpoint/start_reader.hpp"
#include "sweep/read_sweep.hpp"

namespace moraine {
namespace {

struct MemberMistake {
  InputProblem problem;
  SweepValue const* value;  // that the sweep gives; null where it is another key
  std::vector<std::string_view> members;

  bool is(InputProblem const& other) const {
    return std::tie(problem.key, problem.value, problem.rule) ==
           std::tie(other.key, other.value, other.rule);
  }
};

std::string listed(std::vector<std::string_view> const& members) {
  constexpr std::size_t most = 3;
  std::string text = members.size() > 1 ? "members " : "member ";
  for (std::size_t i = 0; i < std::min(members.size(), most); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", members[i]);
  if (members.size() > most) text += fmt::format(" and {} more", members.size() - most);
  return text;
}

SweepValue const* value_of(std::vector<SweepColumn> const& columns, SweepMember const& member,
                           std::string const& key) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].key.path == key) return &member.values[i];
  return nullptr;
}

}  // namespace

std::vector<InputProblem> check_members(SweepPlan const& plan, CaseTemplate const& cases,
                                        Source& source) {
  auto const columns = plan.columns();
  std::vector<MemberMistake> mistakes;
  for (SweepMember const& member : plan.members) try {
      Case c = cases.with(replacements_of(plan, member));
      read_start(c);
    } catch (InputErrors const& errors) {
      for (InputProblem const& problem : errors.problems()) {
        auto found = std::find_if(mistakes.begin(), mistakes.end(),
                                  [&](MemberMistake const& known) { return known.is(problem); });
        if (found == mistakes.end())
          found = mistakes.insert(found, {problem, value_of(columns, member, problem.key), {}});
        found->members.push_back(member.name);
      }
    }
  std::vector<InputProblem> elsewhere;
  for (auto const& [problem, value, members] : mistakes) {
    std::string const rule = fmt::format("{} ({})", problem.rule, listed(members));
    if (value != nullptr)
      source.report_value(problem.key, value->place, rule, problem.hint);
    else
      elsewhere.push_back({source.file(), 0, 0, problem.key, problem.value, rule, problem.hint});
  }
  return elsewhere;
}

}  // namespace moraine
