#include "sweep/sweep_tables.hpp"

#include <vector>

namespace moraine {
namespace {

template <std::size_t N>
std::vector<std::string_view> listed(std::array<std::string_view, N> const& names) {
  return {names.begin(), names.end()};
}

Parameter text(std::string_view key, std::string_view meaning) {
  return {.key = key, .type = ValueType::text, .meaning = meaning};
}

Parameter whole_number(std::string_view key, Limits limits, std::string_view meaning) {
  return {.key = key, .type = ValueType::integer, .limits = limits, .meaning = meaning};
}

Parameter choice(std::string_view key, std::vector<std::string_view> names,
                 std::string_view meaning) {
  return {.key = key, .type = ValueType::choice, .names = std::move(names), .meaning = meaning};
}

std::vector<Entry<SweepHead>> head_table() {
  Parameter file = text("case", "the case file that is varied; its path counts from this file");
  Parameter method =
      choice("method", {"grid", "list", "latin_hypercube"}, "how values are put together");
  for (Parameter* needed : {&file, &method}) needed->presence = Presence::required;
  Parameter at_once =
      whole_number("at_once", Limits::between(1.0, 1024.0), "members that run at the same time");
  at_once.preset = 1;
  auto const most = static_cast<double>(most_members);
  return {member<SweepHead, &SweepHead::title>(text("title", "one line that names the sweep")),
          member<SweepHead, &SweepHead::case_file>(file),
          member<SweepHead, &SweepHead::method>(method),
          member<SweepHead, &SweepHead::at_once>(at_once),
          member<SweepHead, &SweepHead::samples>(whole_number(
              "samples", Limits::between(1.0, most), "number of members of a latin hypercube")),
          member<SweepHead, &SweepHead::seed>(whole_number(
              "seed", Limits::between(0.0, 2147483647.0), "of the draws of a latin hypercube"))};
}

}  // namespace

std::span<Entry<SweepHead> const> sweep_head_entries() {
  static std::vector<Entry<SweepHead>> const table = head_table();
  return table;
}

std::span<Entry<AxisHead> const> axis_entries() {
  static std::vector<Entry<AxisHead>> const table{
      member<AxisHead, &AxisHead::steps>(
          whole_number("steps", Limits::between(2.0, static_cast<double>(most_members)),
                       "number of values of a range")),
      member<AxisHead, &AxisHead::scale>(
          choice("scale", {"linear", "log"}, "how values of a range are spread"))};
  return table;
}

std::span<Entry<OutputHead> const> output_entries() {
  static std::vector<Entry<OutputHead>> const table{
      member<OutputHead, &OutputHead::gauge>(text("gauge", "name of a gauge of the case")),
      member<OutputHead, &OutputHead::sums>(text("sums", "column of sums.csv")),
      member<OutputHead, &OutputHead::run>(
          choice("run", listed(run_number_names), "a number of the run as a whole")),
      member<OutputHead, &OutputHead::column>(text("column", "column of the gauge")),
      member<OutputHead, &OutputHead::measure>(
          choice("measure", listed(measure_names), "what is taken of the readings")),
      member<OutputHead, &OutputHead::label>(text("label", "heading in tables and plots"))};
  return table;
}

}  // namespace moraine
