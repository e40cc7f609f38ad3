// What each topic of `moraine blast` asks for, as tables.
#pragma once

#include <span>
#include <string_view>

#include "base/units.hpp"
#include "blast/relation.hpp"

namespace moraine {

/// Which values an option takes.
enum class Accepts { positive, not_negative, share, below_right_angle };

/// An option with a value and a unit, and the input that it sets.
struct QuantityOption {
  std::string_view flag;
  std::string_view help;
  Dimension dimension;
  Accepts accepts;
  double& (*target)(blast::Situation&);
};
std::span<QuantityOption const> quantity_options();

/// An option that names an entry of a list.
struct NameOption {
  std::string_view flag;
  std::string_view help;
};
std::span<NameOption const> name_options();

/// Options that choose the unit of a kind of result.
struct OutputUnitOption {
  std::string_view flag;
  blast::Kind kind;
};
std::span<OutputUnitOption const> output_unit_options();

/// An input that may run over a range of values.
struct SweepOption {
  std::string_view flag;      // "--distances"
  std::string_view replaces;  // "--distance"
  std::string_view variable;  // "distance"
  bool logarithmic;
};

/// A topic as a command. Flags are separated by blanks.
struct TopicCommand {
  blast::Topic topic;
  std::string_view help;
  std::string_view required;
  std::string_view optional;
  SweepOption sweep;
  std::string_view examples;  // one per line, "moraine blast ..."

  /// Whether it knows an option.
  bool uses(std::string_view flag) const;
};
std::span<TopicCommand const> topic_commands();

/// Whether a list of flags holds one.
bool holds(std::string_view flags, std::string_view flag);

}  // namespace moraine
