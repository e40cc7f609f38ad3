// Entries of the table of parameters that exist for one kind of gauge only.
#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "setup/binding.hpp"
#include "setup/case.hpp"

namespace moraine {

/// Names of the kinds, in the order of the enum.
inline constexpr std::array<std::string_view, gauge_kind_count> gauge_kind_names{
    "point",  "front",   "wall",   "line", "level",      "sums",  "side",    "budget",
    "crater", "deposit", "bubble", "rise", "expression", "plane", "particle"};

constexpr std::string_view name_of(GaugeKind kind) {
  return gauge_kind_names[static_cast<std::size_t>(kind)];
}

/// A member of ProbeSpec, reached through members.
template <GaugeKind kind, auto... Members>
Entry<GaugeSpec> probe_member(Parameter parameter) {
  parameter.section = Section::gauge;
  parameter.when_key = "kind";
  parameter.when_value = name_of(kind);
  auto entry = member<GaugeSpec, &GaugeSpec::probe, Members...>(std::move(parameter));
  entry.get = [](GaugeSpec const& gauge) {
    return gauge.kind == kind ? binding::load(binding::path<Members...>(gauge.probe)) : Value();
  };
  return entry;
}

/// A place that must be given.
template <GaugeKind kind, auto... Members>
Entry<GaugeSpec> place(std::string_view key, std::string_view meaning) {
  return probe_member<kind, Members...>({.key = key,
                                         .type = ValueType::vector,
                                         .quantity = Quantity::length,
                                         .presence = Presence::required,
                                         .meaning = meaning});
}

/// Appends the keys of the kinds from crater to plane.
void add_measure_entries(std::vector<Entry<GaugeSpec>>& table);

}  // namespace moraine
